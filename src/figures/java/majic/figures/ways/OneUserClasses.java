package majic.figures.ways;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Counts the classes of {@code majic} that one other file names, by the words of the sources without comments. */
public final class OneUserClasses {
    private static final Path SOURCES = Path.of("src", "main", "java", "majic");
    private static final Pattern LEFT_OUT =
            Pattern.compile("(?s)/\\*.*?\\*/|//[^\\n]*|\"\"\".*?\"\"\"|\"(\\\\.|[^\"\\\\])*\"");
    private static final Pattern WORD = Pattern.compile("\\w+");

    private OneUserClasses() {}

    /** Returns a line with the share. */
    public static String measure() throws IOException {
        List<Path> files;
        try (Stream<Path> all = Files.walk(SOURCES)) {
            files = all.filter(file -> file.toString().endsWith(".java")).toList();
        }
        Set<String> classes = files.stream()
                .map(OneUserClasses::name)
                .filter(name -> !name.equals("package-info"))
                .collect(Collectors.toSet());
        Map<String, Integer> users = new HashMap<>();
        for (Path file : files) {
            Set<String> words = words(file);
            words.retainAll(classes);
            words.remove(name(file));
            words.forEach(word -> users.merge(word, 1, Integer::sum));
        }
        long one = users.values().stream().filter(count -> count == 1).count();
        return String.format(
                "%d of %d classes are named by one other file only, %.1f %%",
                one, classes.size(), 100.0 * one / classes.size());
    }

    private static String name(Path file) {
        return file.getFileName().toString().replace(".java", "");
    }

    private static Set<String> words(Path file) throws IOException {
        String code = LEFT_OUT.matcher(Files.readString(file)).replaceAll(" ");
        return WORD.matcher(code).results().map(MatchResult::group).collect(Collectors.toCollection(HashSet::new));
    }
}
