package majic.build;

import static java.util.stream.Collectors.toCollection;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;

/**
 * The tables of packages and the diagrams in docs/architecture.md. The tables are the only place where the allowed
 * directions are written; a diagram shows what follows from them.
 */
final class ArchitecturePage {
    private static final Pattern ROW = Pattern.compile("(?m)^\\| `(majic[\\w.]*)` \\|.*\\|([^|]*)\\|$");
    private static final Pattern NAME = Pattern.compile("`([\\w.]+)`");
    private static final Pattern DIAGRAM = Pattern.compile("(?s)```mermaid\nflowchart TD\n +%% (\\S+)\n(.*?)```");
    private static final String TEXT = read();

    private ArchitecturePage() {}

    private static String read() {
        try {
            return Files.readString(Path.of("docs/architecture.md"));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** Returns for each package in a table the packages of its last column. */
    static Map<String, Set<String>> table() {
        Map<String, Set<String>> table = new TreeMap<>();
        ROW.matcher(TEXT)
                .results()
                .forEach(row -> table.put(
                        row.group(1),
                        NAME.matcher(row.group(2))
                                .results()
                                .map(name -> inFull(name.group(1), row.group(1)))
                                .collect(toCollection(TreeSet::new))));
        return table;
    }

    /** Completes a name as the page abbreviates it: ".x" is a package of the row's own group, "x" one of majic. */
    private static String inFull(String name, String row) {
        if (name.startsWith(".")) {
            return group(row) + name;
        }
        return name.startsWith("majicsim") ? name : "majic." + name;
    }

    /** Abbreviates the name of a package for the row of another. */
    static String abbreviated(String name, String row) {
        if (name.startsWith(group(row) + ".")) {
            return name.substring(group(row).length());
        }
        return name.replaceFirst("^majic\\.", "");
    }

    private static String group(String name) {
        return name.replaceFirst("^(\\w+\\.\\w+)\\..*", "$1");
    }

    /** Returns the lines of each diagram, by the package that it is of. */
    static Map<String, List<String>> diagrams() {
        Map<String, List<String>> diagrams = new TreeMap<>();
        DIAGRAM.matcher(TEXT).results().forEach(diagram -> diagrams.put(diagram.group(1), lines(diagram)));
        return diagrams;
    }

    private static List<String> lines(MatchResult diagram) {
        return Arrays.stream(diagram.group(2).split("\n"))
                .map(String::strip)
                .filter(line -> !line.isEmpty())
                .toList();
    }

    /**
     * Returns the lines that a diagram must have: one for each node that uses others, with an arrow to each that it
     * does not also reach by way of another.
     */
    static List<String> diagram(String of, Map<String, Set<String>> uses) {
        Map<String, Set<String>> arrows = new TreeMap<>();
        uses.forEach((from, all) -> all.forEach(to -> addArrow(arrows, node(from, of), node(to, of))));
        return arrows.keySet().stream()
                .map(from -> from + " --> "
                        + String.join(
                                " & ",
                                arrows.get(from).stream()
                                        .filter(to -> arrows.get(from).stream()
                                                .noneMatch(by ->
                                                        reached(by, arrows).contains(to)))
                                        .toList()))
                .toList();
    }

    private static void addArrow(Map<String, Set<String>> arrows, String from, String to) {
        if (!from.isEmpty() && !to.isEmpty() && !from.equals(to)) {
            arrows.computeIfAbsent(from, node -> new TreeSet<>()).add(to);
        }
    }

    /**
     * Returns the node that stands for a package in the diagram of another, with all packages below one as one node, or
     * "" where it is not shown.
     */
    private static String node(String name, String diagram) {
        if (name.equals(diagram)) {
            return name.substring(name.lastIndexOf('.') + 1);
        }
        if (name.startsWith(diagram + ".")) {
            return name.substring(diagram.length() + 1).replaceFirst("\\..*", "");
        }
        return diagram.equals("majic") ? "majicsim" : "";
    }

    private static Set<String> reached(String from, Map<String, Set<String>> arrows) {
        Set<String> reached = new TreeSet<>(arrows.getOrDefault(from, Set.of()));
        List.copyOf(reached).forEach(to -> reached.addAll(reached(to, arrows)));
        return reached;
    }
}
