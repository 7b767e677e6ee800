package majic.console;

import java.util.Arrays;
import java.util.LinkedHashSet;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;

/**
 * The question for the user name and the password of a broker that refused those it was given. It is asked when the
 * user is ready for it, so that a line that is being typed, which may be a stop, is never taken for an answer.
 * Thread-safe.
 */
final class LoginQuestion {
    private final Prompts prompts;
    private final Set<String> lines = new LinkedHashSet<>();
    private @Nullable String address;

    /** Asks at a terminal. */
    interface Prompts {
        /** Returns what the user types after a prompt; null at the end of the input. Blocks. */
        @Nullable
        String text(String prompt);

        /** Returns what the user types invisibly after a prompt; null at the end of the input. Blocks. */
        char @Nullable [] secret(String prompt);

        /** Returns whether an answer is a stop, which is executed and is no answer then. */
        boolean isStop(String answer);

        /** Uses the user name and the password for the broker of an address. */
        void use(String address, String user, char[] password);
    }

    LoginQuestion(Prompts prompts) {
        this.prompts = prompts;
    }

    /**
     * Notes that a broker has refused the user name or the password.
     *
     * @param refusing an address at the broker
     * @param again the line to run with others
     * @return a sentence for the user; empty if it was shown before
     */
    synchronized Optional<String> note(String refusing, String again) {
        boolean first = lines.isEmpty();
        address = refusing;
        lines.add(again);
        return first
                ? Optional.of("press Enter on an empty line to type the user name and the password")
                : Optional.empty();
    }

    /**
     * Asks, if a broker has refused something since the last time; returns the lines to run now, empty if there are
     * none.
     */
    String ask() {
        String broker;
        String again;
        synchronized (this) {
            if (address == null) {
                return "";
            }
            broker = address;
            again = String.join("\n", lines);
            address = null;
            lines.clear();
        }
        return answered(broker, again);
    }

    private String answered(String broker, String again) {
        String user = prompts.text("User at the broker of " + broker + ": ");
        if (user == null || user.isBlank() || prompts.isStop(user)) {
            return user == null ? "" : user;
        }
        char[] password = prompts.secret("Password: ");
        if (password == null) {
            return "";
        }
        String typed = new String(password);
        if (prompts.isStop(typed)) {
            return typed;
        }
        prompts.use(broker, user.strip(), password);
        Arrays.fill(password, ' ');
        return again;
    }
}
