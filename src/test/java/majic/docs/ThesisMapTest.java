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
import org.junit.jupiter.api.Test;

/** The page on the thesis names only classes, methods and tests that exist, and the guide follows the thesis. */
class ThesisMapTest {
    private static final Pattern NAME = Pattern.compile("`([A-Z]\\w*[a-z]\\w*)(?:[.#](\\w+))?`");
    private static final Pattern GUIDE = Pattern.compile("(?m)^\\| \\[[^]]+]\\((guide/[\\w-]+\\.md)\\)");
    private static final Path TARGET = Path.of(System.getProperty("majic.target", "target"));

    /** Full names of classes by simple name; tests of two packages may have the same one. */
    private final Map<String, List<String>> classes = new HashMap<>();

    @Test
    void everyClassMethodAndTestOnThePageExists() throws IOException {
        collect(TARGET.resolve("classes"));
        collect(TARGET.resolve("test-classes"));
        String page = Files.readString(Path.of("docs/thesis-map.md"));
        assertThat(NAME.matcher(page).results()).hasSizeGreaterThan(100).allSatisfy(this::assertExists);
    }

    @Test
    void theUsersGuideHasTheOrderOfTheThesis() throws IOException {
        StringBuilder guide = new StringBuilder();
        for (MatchResult page :
                GUIDE.matcher(Page.of("docs/user-guide.md").text()).results().toList()) {
            guide.append(Page.of("docs/" + page.group(1)).text());
        }
        assertThat(guide.toString())
                .containsSubsequence(
                        "\n## The main screen\n",
                        "\n## Adding a robot\n",
                        "\n## Passing commands\n",
                        "\n## The help screen\n",
                        "\n## Saving a session\n",
                        "\n## Saving a parameter log\n",
                        "# Loading acts\n",
                        "\n## Removing a robot\n",
                        "\n## Quitting\n");
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
        assertThat(classes).containsKey(name.group(1));
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
        }
        return members;
    }
}
