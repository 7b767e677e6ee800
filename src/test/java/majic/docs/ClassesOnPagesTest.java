package majic.docs;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.lang.reflect.Member;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The pages that describe the code name only classes, methods and tests that exist. */
class ClassesOnPagesTest {
    private static final Pattern NAME = Pattern.compile("`([A-Z]\\w*[a-z]\\w*)(?:[.#](\\w+))?`");
    private static final Path TARGET = Path.of(System.getProperty("majic.target", "target"));

    /** Full names of classes by simple name; tests of two packages may have the same one. */
    private final Map<String, List<String>> classes = new HashMap<>();

    @ParameterizedTest
    @CsvSource({"docs/thesis-map.md, 100", "docs/architecture.md, 20", "docs/stop-threads-time.md, 10"})
    void everyClassMethodAndTestOnThePageExists(String page, int least) throws IOException {
        collect(TARGET.resolve("classes"));
        collect(TARGET.resolve("test-classes"));
        assertThat(NAME.matcher(Page.of(page).text()).results())
                .hasSizeGreaterThan(least)
                .allSatisfy(this::assertExists);
    }

    private void collect(Path folder) throws IOException {
        try (Stream<Path> files = Files.walk(folder)) {
            files.map(file -> "" + folder.relativize(file))
                    .filter(file -> file.endsWith(".class"))
                    .map(file ->
                            file.substring(0, file.length() - ".class".length()).replaceAll("[/\\\\]", "."))
                    .forEach(name -> classes.computeIfAbsent(
                                    name.substring(name.lastIndexOf('.') + 1), simple -> new ArrayList<>())
                            .add(name));
        }
    }

    private void assertExists(MatchResult name) throws ReflectiveOperationException, IOException {
        if (isShippedAct(name.group(1))) {
            return;
        }
        assertThat(classes.containsKey(name.group(1))).as(name.group()).isTrue();
        if (name.group(2) != null) {
            assertThat(members(name.group(1))).as(name.group()).contains(name.group(2));
        }
    }

    private static boolean isShippedAct(String name) throws IOException {
        return Files.exists(Path.of("src/main/resources/acts", name + ".java"));
    }

    private List<String> members(String simpleName) throws ReflectiveOperationException {
        List<String> members = new ArrayList<>();
        for (String name : classes.get(simpleName)) {
            Class<?> type = Class.forName(name, false, getClass().getClassLoader());
            Stream.<Member>concat(Stream.of(type.getDeclaredMethods()), Stream.of(type.getDeclaredFields()))
                    .map(Member::getName)
                    .forEach(members::add);
            Stream.of(type.getDeclaredClasses()).map(Class::getSimpleName).forEach(members::add);
        }
        return members;
    }
}
