package majic.text;

import java.util.Enumeration;
import java.util.Locale;
import java.util.ResourceBundle;
import java.util.Set;
import java.util.function.BiFunction;
import java.util.regex.Pattern;

/**
 * The texts of windows in an invented language, until it is closed: the English ones between two marks. What a window
 * shows without marks does not come from a resource bundle.
 */
public final class MarkedTexts implements AutoCloseable {
    /** The invented language. */
    public static final Locale LANGUAGE = Locale.forLanguageTag("qps");

    /** Keys of the names of files that are in a language. */
    private static final Set<String> FILES = Set.of("commands.file", "keys.file");

    private static final Pattern MARKED = Pattern.compile("(?s)⟦[^⟦⟧]*⟧");

    private final BiFunction<Class<?>, Locale, ResourceBundle> before = Texts.bundles;

    /** Makes windows whose language is {@link #LANGUAGE} read marked texts. */
    public MarkedTexts() {
        Texts.bundles = (user, language) -> new Marked(before.apply(user, Locale.ENGLISH));
    }

    @Override
    public void close() {
        Texts.bundles = before;
    }

    /** Returns an English text as it is shown in the invented language. */
    public String mark(String english) {
        return marked(english);
    }

    private static String marked(String english) {
        return "⟦" + english + "⟧";
    }

    /** Returns {@link #LANGUAGE}. */
    public Locale language() {
        return LANGUAGE;
    }

    /** Returns what of a shown text is not marked; values inside a marked text count as marked. */
    public static String unmarked(String shown) {
        String rest = MARKED.matcher(shown).replaceAll("");
        return rest.equals(shown) ? rest : unmarked(rest);
    }

    private static final class Marked extends ResourceBundle {
        private final ResourceBundle english;

        private Marked(ResourceBundle english) {
            this.english = english;
        }

        /** Leaves the names of files as they are. */
        @Override
        protected Object handleGetObject(String key) {
            return FILES.contains(key) ? english.getString(key) : marked(english.getString(key));
        }

        @Override
        public Enumeration<String> getKeys() {
            return english.getKeys();
        }
    }
}
