package majic.text;

import java.text.Format;
import java.text.MessageFormat;
import java.util.List;
import java.util.Locale;
import java.util.ResourceBundle;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;

/**
 * The texts of a package's windows in the user's language: its resource bundle {@code Texts}, a properties file beside the
 * classes. The language is the default locale; one without a bundle gets English. May be
 * used on any thread.
 */
public final class Texts {
    /** Finds the bundles; tests use another one for a while. */
    static volatile ResourceBundle.Control control = new ExistingFiles();

    private final Class<?> user;

    private Texts(Class<?> user) {
        this.user = user;
    }

    /** Returns the texts of the package of a class. */
    public static Texts of(Class<?> user) {
        return new Texts(user);
    }

    /**
     * Returns a text.
     *
     * @param key its key in the bundle
     * @param values put in place of {@code {0}}, {@code {1}}, as {@link String#valueOf(Object)} writes them; the patterns are
     *     those of {@link MessageFormat}, so an apostrophe is doubled in the file
     * @throws java.util.MissingResourceException if the bundle has no such text
     */
    public String get(String key, Object... values) {
        Locale language = Locale.getDefault();
        String text = bundle(language).getString(key);
        return values.length == 0 && text.indexOf('\'') < 0 ? text : format(text, language, values);
    }

    private static String format(String text, Locale language, Object... values) {
        MessageFormat pattern = new MessageFormat(text, language);
        Format[] formats = pattern.getFormatsByArgumentIndex();
        Object[] words = IntStream.range(0, values.length)
                .mapToObj(index -> isPlain(formats, index) ? String.valueOf(values[index]) : values[index])
                .toArray();
        return pattern.format(words);
    }

    /** Returns whether a value has no format of its own; a number is then written without separators, like a port. */
    private static boolean isPlain(Format[] formats, int index) {
        return index >= formats.length || formats[index] == null;
    }

    private ResourceBundle bundle(Locale language) {
        return ResourceBundle.getBundle(user.getPackageName() + ".Texts", language, user.getClassLoader(), control);
    }

    /** Looks only for files that exist, since a search for a missing one opens every library and delays the window. */
    private static final class ExistingFiles extends ResourceBundle.Control {
        @Override
        public List<String> getFormats(String name) {
            return FORMAT_PROPERTIES;
        }

        @Override
        public List<Locale> getCandidateLocales(String name, Locale locale) {
            boolean german = locale.getLanguage().equals(Locale.GERMAN.getLanguage());
            return german ? List.of(Locale.GERMAN, Locale.ROOT) : List.of(Locale.ROOT);
        }

        @Override
        public @Nullable Locale getFallbackLocale(String name, Locale locale) {
            return null;
        }
    }
}
