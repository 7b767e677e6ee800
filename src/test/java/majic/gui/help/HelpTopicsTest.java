package majic.gui.help;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** The sections that F1 opens are headings of the user's guide. */
class HelpTopicsTest {
    private static final Pattern TOPIC = Pattern.compile("HelpTopic\\.set\\([^\"]*\"([^\"]+)\"");
    private static final Pattern HEADING = Pattern.compile("<h\\d id=\"([^\"]+)\"");

    @Test
    void eachSectionThatAWindowNamesIsInTheGuide() throws IOException {
        Set<String> named = new TreeSet<>();
        for (Path source : sources()) {
            TOPIC.matcher(Files.readString(source)).results().forEach(found -> named.add(found.group(1)));
        }
        Set<String> headings = GuidePage.read("user-guide").sections().stream()
                .flatMap(section -> HEADING.matcher(section.html()).results())
                .map(found -> found.group(1))
                .collect(Collectors.toSet());
        assertThat(named).isNotEmpty();
        assertThat(headings).containsAll(named);
    }

    private static List<Path> sources() throws IOException {
        try (Stream<Path> files = Files.walk(Path.of("src/main/java/majic/gui"))) {
            return files.filter(file -> file.toString().endsWith(".java")).toList();
        }
    }
}
