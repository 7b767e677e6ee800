package majic.script.help;

import java.io.File;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import majic.script.syntax.Token;

/**
 * A file's name that is being typed at the end of a line. Immutable.
 *
 * @param start where it begins in the line
 * @param written its characters so far, with the quote in front if there is one
 */
record BegunFile(int start, String written) {
    private static final int MOST_ENTRIES = 500;

    /** A name that the scanner reads as one value without quotes. */
    private static final Pattern PLAIN = Pattern.compile("[\\p{L}\\d._/\\\\:~+-]+");

    /**
     * Finds the name at the end of a text.
     *
     * @param tokens all tokens of the text
     * @param argument the index of the token that begins the name; the number of tokens if none has been typed
     * @return empty if the text ends elsewhere, or if the quotes of the name are closed
     */
    static Optional<BegunFile> of(String text, List<Token> tokens, int argument) {
        if (argument > tokens.size()) {
            return Optional.empty();
        }
        int start = argument < tokens.size() ? tokens.get(argument).column() - 1 : text.length();
        int end = tokens.get(argument - 1).end() - 1;
        String written = text.substring(start);
        boolean quoted = written.startsWith("\"");
        boolean whole = quoted ? written.indexOf('"', 1) < 0 : written.chars().noneMatch(Character::isWhitespace);
        return start > end && whole ? Optional.of(new BegunFile(start, written)) : Optional.empty();
    }

    /** Returns whether it begins with a folder. */
    boolean hasFolder() {
        return path().length() > name().length();
    }

    private boolean isQuoted() {
        return written.startsWith("\"");
    }

    private String path() {
        return isQuoted() ? written.substring(1) : written;
    }

    /** Returns the part behind the last folder. */
    private String name() {
        String path = path();
        return path.substring(1 + Math.max(path.lastIndexOf('/'), path.lastIndexOf(File.separatorChar)));
    }

    Completions completions() {
        return completions(name -> true);
    }

    /**
     * Lists the folders and files of which this may be the beginning. Reads a folder.
     *
     * @param offered whether a file with a name is offered
     * @return whole paths as a line needs them, at most {@value #MOST_ENTRIES}; a folder ends with a slash. Empty if
     *     the folder cannot be read
     */
    Completions completions(Predicate<String> offered) {
        String name = name();
        String folder = path().substring(0, path().length() - name.length());
        try (Stream<Path> files = Files.list(Path.of(folder.isEmpty() ? "." : folder))) {
            return new Completions(
                    start,
                    files.filter(file -> fits(file, name.toLowerCase(Locale.ROOT), offered))
                            .limit(MOST_ENTRIES)
                            .map(file -> entry(folder, file))
                            .sorted(Comparator.comparing(Completion::text, String.CASE_INSENSITIVE_ORDER))
                            .toList());
        } catch (IOException | UncheckedIOException | InvalidPathException | SecurityException e) {
            return new Completions(start, List.of());
        }
    }

    private static boolean fits(Path file, String begun, Predicate<String> offered) {
        String name = file.getFileName().toString().toLowerCase(Locale.ROOT);
        boolean hidden = name.startsWith(".") && !begun.startsWith(".");
        return name.startsWith(begun)
                && !hidden
                && name.indexOf('"') < 0
                && (offered.test(name) || Files.isDirectory(file));
    }

    private Completion entry(String folder, Path file) {
        boolean isFolder = Files.isDirectory(file);
        String path = folder + file.getFileName() + (isFolder ? "/" : "");
        boolean quoted = isQuoted() || !PLAIN.matcher(path).matches();
        return Completion.word(quoted ? "\"" + path + (isFolder ? "" : "\"") : path, isFolder ? "a folder" : "a file");
    }
}
