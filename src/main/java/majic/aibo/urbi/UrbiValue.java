package majic.aibo.urbi;

import java.util.List;

/** A value as an URBI server prints it (URBI sheet 4). Immutable. */
public sealed interface UrbiValue {

    /**
     * A number; URBI has no other kind of truth value.
     *
     * @param amount not finite for {@code inf}, {@code -inf} and {@code nan}
     */
    record Num(double amount) implements UrbiValue {}

    /**
     * A string, without its quotes.
     *
     * @param text with {@code \"}, {@code \\} and {@code \n} resolved
     */
    record Str(String text) implements UrbiValue {}

    /**
     * A list.
     *
     * @param items in order
     */
    record Items(List<UrbiValue> items) implements UrbiValue {
        /** Keeps a copy of the list. */
        public Items {
            items = List.copyOf(items);
        }
    }

    /**
     * Raw bytes with the server's description of them.
     *
     * @param words type and parameters as printed, such as {@code jpeg 208 160}; servers may repeat the last one
     * @param bytes the content; not to be changed
     */
    record Binary(List<String> words, byte[] bytes) implements UrbiValue {
        /** Keeps a copy of the words. */
        public Binary {
            words = List.copyOf(words);
        }
    }

    /**
     * Anything else, such as an object.
     *
     * @param text as printed
     */
    record Other(String text) implements UrbiValue {}
}
