package majic.docs;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/** A page of the documentation, with its code. Immutable. */
public record Page(Path path, String text) {
    private static final Pattern BLOCK = Pattern.compile("(?ms)^ *```(\\w*)\\R(.*?)^ *```$");
    private static final Pattern SPAN = Pattern.compile("`([^`\\n]+)`");

    /**
     * A piece of code of a page.
     *
     * @param path the page
     * @param line the line of the page on which the code begins
     * @param language the language that the page names, empty if none
     * @param text the code
     */
    public record Code(Path path, int line, String language, String text) {
        public List<String> lines() {
            return text.lines().toList();
        }

        /** Returns the place of the code, for messages. */
        @Override
        public String toString() {
            return path + ":" + line;
        }
    }

    /** Returns the page in a file, named from the top of the repository. */
    public static Page of(String file) {
        return of(Path.of(file));
    }

    private static Page of(Path file) {
        try {
            return new Page(file, Files.readString(file));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** Returns all pages. */
    public static List<Page> all() {
        List<Path> files = new ArrayList<>(List.of(Path.of("README.md"), Path.of("CONTRIBUTING.md")));
        try (Stream<Path> docs = Files.walk(Path.of("docs"))) {
            docs.filter(file -> file.toString().endsWith(".md")).sorted().forEach(files::add);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return files.stream().map(Page::of).toList();
    }

    /** Returns the code blocks. */
    public List<Code> blocks() {
        return BLOCK.matcher(text)
                .results()
                .map(found -> new Code(path, lineOf(found, 2), found.group(1), found.group(2)))
                .toList();
    }

    /** Returns the code blocks in a language. */
    public Stream<Code> blocks(String language) {
        return blocks().stream().filter(block -> block.language().equals(language));
    }

    /** Returns the first code block in a language that contains a text. */
    public Code block(String language, String part) {
        return blocks(language)
                .filter(block -> block.text().contains(part))
                .findFirst()
                .orElseThrow();
    }

    /** Returns the code within sentences, as {@code `./majic --lab`}. */
    public Stream<Code> spans() {
        String withoutBlocks =
                BLOCK.matcher(text).replaceAll(found -> found.group().replaceAll("[^\\n]", " "));
        return SPAN.matcher(withoutBlocks).results().map(found -> new Code(path, lineOf(found, 1), "", found.group(1)));
    }

    private int lineOf(MatchResult found, int group) {
        return 1
                + (int) text.substring(0, found.start(group))
                        .chars()
                        .filter(c -> c == '\n')
                        .count();
    }
}
