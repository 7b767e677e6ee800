package majic.docs;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;

/** The user's guide follows the thesis. */
class ThesisMapTest {
    private static final Pattern GUIDE = Pattern.compile("(?m)^\\| \\[[^]]+]\\((guide/[\\w-]+\\.md)\\)");

    @Test
    void theUsersGuideHasTheOrderOfTheThesis() {
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
}
