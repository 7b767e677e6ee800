package majic.build;

import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.core.domain.Dependency;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** The size of packages, the names of classes, and circles of classes that depend on each other. */
class ClassStructureTest {
    private static final Path TESTS = Path.of("src/test/java");
    private static final int MOST_FILES = 40;
    private static final int LARGEST_CIRCLE = 5;

    /**
     * Larger circles that are allowed. In the simulated URBI interpreter a task may run any command, and a command may
     * start any task.
     */
    private static final Map<String, Integer> LARGER_CIRCLES = Map.of("majicsim.aibo.urbi.run", 6);

    /** The classes each top-level class depends on, nested classes counted as part of it; all without tests. */
    private static final Map<String, Set<String>> USES = uses();

    private static Map<String, Set<String>> uses() {
        Map<String, Set<String>> uses = new TreeMap<>();
        new ClassFileImporter()
                .withImportOption(location -> !location.contains("/test-classes/"))
                .importPackages("majic", "majicsim")
                .forEach(type -> uses.computeIfAbsent(topLevel(type), name -> new TreeSet<>())
                        .addAll(type.getDirectDependenciesFromSelf().stream()
                                .map(Dependency::getTargetClass)
                                .map(ClassStructureTest::topLevel)
                                .filter(name -> name.startsWith("majic"))
                                .toList()));
        uses.keySet().removeIf(name -> name.endsWith("package-info"));
        return uses;
    }

    private static String topLevel(JavaClass type) {
        return type.getBaseComponentType().getName().replaceFirst("\\$.*", "");
    }

    @Test
    void noPackageHasMoreThanFortyFiles() {
        Map<String, Long> files = USES.keySet().stream()
                .collect(Collectors.groupingBy(ClassStructureTest::packageOf, Collectors.counting()));
        assertThat(files)
                .isNotEmpty()
                .allSatisfy((name, count) -> assertThat(count).isLessThanOrEqualTo(MOST_FILES));
    }

    @Test
    void noPackageOfTestsHasMoreThanFortyFiles() throws IOException {
        try (Stream<Path> sources = Files.walk(TESTS)) {
            Map<Path, Long> files = sources.filter(path -> path.toString().endsWith(".java"))
                    .collect(Collectors.groupingBy(Path::getParent, Collectors.counting()));
            assertThat(files)
                    .isNotEmpty()
                    .allSatisfy((folder, count) -> assertThat(count).isLessThanOrEqualTo(MOST_FILES));
        }
    }

    @Test
    void oneSimpleNameStandsForOneClass() {
        Map<String, List<String>> bySimpleName = USES.keySet().stream()
                .filter(name -> name.startsWith("majic."))
                .collect(Collectors.groupingBy(ClassStructureTest::simpleName));
        assertThat(bySimpleName.values())
                .isNotEmpty()
                .allSatisfy(names -> assertThat(names).hasSize(1));
    }

    @Test
    void noManyClassesDependOnEachOther() {
        assertThat(circles())
                .isNotEmpty()
                .allSatisfy(circle -> assertThat(circle)
                        .hasSizeLessThanOrEqualTo(LARGER_CIRCLES.getOrDefault(
                                packageOf(circle.iterator().next()), LARGEST_CIRCLE)));
    }

    private static String packageOf(String name) {
        return name.substring(0, name.lastIndexOf('.'));
    }

    private static String simpleName(String name) {
        return name.substring(name.lastIndexOf('.') + 1);
    }

    /** The groups of two and more classes of which each depends on every other, directly or by way of others. */
    private static List<Set<String>> circles() {
        Map<String, Set<String>> reached = new HashMap<>();
        USES.keySet().forEach(name -> reached.put(name, reachedFrom(name)));
        Set<String> placed = new HashSet<>();
        List<Set<String>> circles = new ArrayList<>();
        for (String name : USES.keySet()) {
            if (placed.add(name)) {
                Set<String> circle = reached.get(name).stream()
                        .filter(other -> reached.get(other).contains(name))
                        .collect(Collectors.toCollection(TreeSet::new));
                placed.addAll(circle);
                circles.add(circle);
            }
        }
        circles.removeIf(circle -> circle.size() < 2);
        return circles;
    }

    private static Set<String> reachedFrom(String name) {
        Set<String> reached = new HashSet<>();
        Deque<String> open = new ArrayDeque<>(USES.get(name));
        while (!open.isEmpty()) {
            String next = open.pop();
            if (USES.containsKey(next) && reached.add(next)) {
                open.addAll(USES.get(next));
            }
        }
        return reached;
    }
}
