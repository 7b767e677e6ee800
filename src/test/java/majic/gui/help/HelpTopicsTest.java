package majic.gui.help;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** The sections that F1 opens are headings of the user's guide, which Help shows with all its pages. */
class HelpTopicsTest {
    private static final Pattern TOPIC = Pattern.compile("HelpTopic\\.set\\([^\"]*\"([^\"]+)\"");
    private static final Pattern HEADING = Pattern.compile("<h\\d id=\"([^\"]+)\"");
    private static final Pattern LISTED = Pattern.compile("(?m)^\\| \\[[^]]+]\\((guide/[\\w-]+)\\.md\\)");

    @Test
    void eachSectionThatAWindowNamesIsInTheGuide() throws IOException {
        Set<String> named = new TreeSet<>();
        for (Path source : sources()) {
            TOPIC.matcher(Files.readString(source)).results().forEach(found -> named.add(found.group(1)));
        }
        List<String> headings = GuidePage.read(HelpDialog.GUIDE).sections().stream()
                .flatMap(section -> HEADING.matcher(section.html()).results())
                .map(found -> found.group(1))
                .toList();
        assertThat(named).isNotEmpty();
        assertThat(headings).containsAll(named).doesNotHaveDuplicates();
    }

    @Test
    void helpShowsThePagesThatTheFirstOneListsAndThereIsNoOther() throws IOException {
        List<String> pages = HelpDialog.GUIDE.subList(1, HelpDialog.GUIDE.size());
        List<String> listed = LISTED.matcher(Files.readString(Path.of("docs", HelpDialog.GUIDE.get(0) + ".md")))
                .results()
                .map(page -> page.group(1))
                .toList();
        assertThat(listed).isEqualTo(pages);
        try (Stream<Path> files = Files.list(Path.of("docs/guide"))) {
            assertThat(files.map(file -> "guide/" + file.getFileName()))
                    .containsExactlyInAnyOrderElementsOf(
                            pages.stream().map(page -> page + ".md").toList());
        }
    }

    private static List<Path> sources() throws IOException {
        try (Stream<Path> files = Files.walk(Path.of("src/main/java/majic/gui"))) {
            return files.filter(file -> file.toString().endsWith(".java")).toList();
        }
    }
}
