package majic.docs;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Tests the links between the pages of the documentation, and those of the change log: each leads to a file, and to a
 * heading if it names one.
 */
class LinksOnPagesTest {
    private static final Pattern BLOCK = Pattern.compile("(?ms)^ *```.*?^ *```$");
    private static final Pattern LINK = Pattern.compile("]\\((?!https?:)([^)#\\s]*)(?:#([^)\\s]+))?\\)");
    private static final Pattern HEADING = Pattern.compile("(?m)^#+ (.*)$");

    static Stream<Page> pages() {
        return Stream.concat(Page.all().stream(), Stream.of(Page.of("CHANGELOG.md")));
    }

    @ParameterizedTest
    @MethodSource("pages")
    void everyLinkLeadsSomewhere(Page page) {
        assertThat(LINK.matcher(withoutBlocks(page)).results()).allSatisfy(link -> {
            Path target = link.group(1).isEmpty()
                    ? page.path()
                    : page.path().resolveSibling(link.group(1)).normalize();
            assertThat(target).exists();
            if (link.group(2) != null) {
                assertThat(anchors(Page.of(target.toString()))).contains(link.group(2));
            }
        });
    }

    private static String withoutBlocks(Page page) {
        return BLOCK.matcher(page.text()).replaceAll("");
    }

    /** The names of headings as the usual viewers make them: small letters, dashes for blanks, no other signs. */
    private static List<String> anchors(Page page) {
        return HEADING.matcher(withoutBlocks(page))
                .results()
                .map(heading -> heading.group(1)
                        .toLowerCase(Locale.ROOT)
                        .replaceAll("[^\\w\\- ]", "")
                        .replace(' ', '-'))
                .toList();
    }
}
