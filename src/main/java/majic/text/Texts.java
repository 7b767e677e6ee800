package majic.text;

import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.text.Format;
import java.text.MessageFormat;
import java.util.Locale;
import java.util.Map;
import java.util.MissingResourceException;
import java.util.PropertyResourceBundle;
import java.util.ResourceBundle;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.BiFunction;
import org.jspecify.annotations.Nullable;

/**
 * The texts of a package's windows in the user's language: its resource bundle {@code Texts}, a properties file beside
 * the classes. The language is the default locale; one without a bundle gets English. May be used on any thread.
 */
public final class Texts {
    /** Finds the bundle of the package of a class; tests use another function for a while. */
    static volatile BiFunction<Class<?>, Locale, ResourceBundle> bundles = Texts::bundle;

    /** The bundles that have been read, by package; plug-ins have packages of their own. */
    private static final Map<Package, ResourceBundle> ENGLISH = new ConcurrentHashMap<>();

    private static final Map<Package, ResourceBundle> GERMAN = new ConcurrentHashMap<>();

    private final Class<?> user;

    private Texts(Class<?> user) {
        this.user = user;
    }

    /** Returns the texts of the package of a class. */
    public static Texts of(Class<?> user) {
        return new Texts(user);
    }

    /** Reads the texts of the package of a class, so that the first use of them does not wait for their file. */
    public static void load(Class<?> user) {
        bundles.apply(user, Locale.getDefault());
    }

    /**
     * Returns a text.
     *
     * @param key its key in the bundle
     * @param values put in place of {@code {0}}, {@code {1}}, as {@link String#valueOf(Object)} writes them, but
     *     numbers as {@link NumberText#of}; the patterns are those of {@link MessageFormat}, so an apostrophe is
     *     doubled in the file
     * @throws MissingResourceException if the bundle has no such text
     */
    public String get(String key, Object... values) {
        Locale language = Locale.getDefault();
        String text = bundles.apply(user, language).getString(key);
        return values.length == 0 && text.indexOf('\'') < 0 ? text : format(text, language, values);
    }

    private static String format(String text, Locale language, Object... values) {
        MessageFormat pattern = new MessageFormat(text, language);
        Format[] formats = pattern.getFormatsByArgumentIndex();
        Object[] words = new Object[values.length];
        for (int index = 0; index < words.length; index++) {
            words[index] = isPlain(formats, index) ? plain(values[index]) : values[index];
        }
        return pattern.format(words);
    }

    private static String plain(Object value) {
        return value instanceof Number ? NumberText.of(value) : String.valueOf(value);
    }

    /** Returns whether a value has no format of its own; a number is then written without separators, like a port. */
    private static boolean isPlain(Format[] formats, int index) {
        return index >= formats.length || formats[index] == null;
    }

    /** Returns the bundle of a package in a language, which is read once. */
    private static ResourceBundle bundle(Class<?> user, Locale language) {
        boolean german = language.getLanguage().equals(Locale.GERMAN.getLanguage());
        Map<Package, ResourceBundle> read = german ? GERMAN : ENGLISH;
        ResourceBundle known = read.get(user.getPackage());
        return known == null ? read.computeIfAbsent(user.getPackage(), made -> read(user, german)) : known;
    }

    private static ResourceBundle read(Class<?> user, boolean german) {
        ResourceBundle english = read(user, "Texts.properties", null);
        if (english == null) {
            throw new MissingResourceException("there are no texts in " + user.getPackageName(), user.getName(), "");
        }
        ResourceBundle own = german ? read(user, "Texts_de.properties", english) : null;
        return own == null ? english : own;
    }

    private static @Nullable ResourceBundle read(Class<?> user, String file, @Nullable ResourceBundle otherwise) {
        try (InputStream bytes = user.getResourceAsStream(file)) {
            return bytes == null ? null : new Bundle(bytes, otherwise);
        } catch (IOException e) {
            throw new UncheckedIOException(file + " of " + user, e);
        }
    }

    /** The texts of a file, and those of another bundle that it does not have. */
    private static final class Bundle extends PropertyResourceBundle {
        Bundle(InputStream bytes, @Nullable ResourceBundle otherwise) throws IOException {
            super(new InputStreamReader(bytes, StandardCharsets.UTF_8));
            setParent(otherwise);
        }
    }
}
