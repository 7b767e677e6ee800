package majic.docs;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import majic.bot.Pose;
import majic.inlab.LabRig;
import majic.inlab.acts.ActLabs;
import majic.script.MajicParser;
import majic.script.ScriptRunner;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Runs the blocks of MAJIC Script on the pages with the simulated robots, and checks the lines within sentences against
 * them. On the page of a robot, number 1 is this robot; on all others 1 is the Aibo, 2 the Pioneer and 3 the Hemisson.
 */
class ScriptOnPagesInLabTest {
    /** Where a loop that walks to an obstacle ends soon. */
    private static final Pose NEAR_A_WALL = new Pose(2600, 1900, 0);

    private static final Pattern ROBOT_PAGE = Pattern.compile("robots/(aibo|pioneer|hemisson|ros)");

    /** A line of an act, or one that names a file; {@link ActsPageTest} runs those of its page. */
    private static final Pattern ELSEWHERE = Pattern.compile("\\bme \\w|\\.(wav|act|majic)\\b| act ");

    static Stream<Page.Code> blocks() {
        return Page.all().stream()
                .flatMap(page -> page.blocks("majic"))
                .filter(block -> !ELSEWHERE.matcher(block.text()).find());
    }

    static Stream<Page> pages() {
        return Page.all().stream().filter(page -> linesOf(page).findAny().isPresent());
    }

    private static Stream<Page.Code> linesOf(Page page) {
        return page.spans()
                .filter(LinesOnPagesTest::isForRobots)
                .filter(line -> !ELSEWHERE.matcher(line.text()).find());
    }

    @ParameterizedTest
    @MethodSource("blocks")
    void everyBlockIsDone(Page.Code block) throws InterruptedException {
        try (LabRig rig = robotsOf(block.path().toString())) {
            MajicParser parser = MajicParser.pipe(rig.session());
            for (String line : block.lines()) {
                assertThat(parser.parseText(line)).as(line).isEmpty();
            }
            parser.awaitAll();
            assertThat(rig.said()).noneMatch(line -> line.contains("failed"));
        }
    }

    @ParameterizedTest
    @MethodSource("pages")
    void everyLineIsRightForItsRobot(Page page) {
        try (LabRig rig = robotsOf(page.path().toString())) {
            ScriptRunner runner = new ScriptRunner(rig.session());
            assertThat(linesOf(page))
                    .allSatisfy(line ->
                            assertThat(runner.check(line.text()).mistakes()).isEqualTo(List.of()));
        }
    }

    private static LabRig robotsOf(String page) {
        Matcher robot = ROBOT_PAGE.matcher(page);
        if (robot.find()) {
            LabRig lab = robot.group(1).equals("ros") ? LabRig.exactWithRos("1") : LabRig.exact();
            lab.add(robot.group(1));
            return lab;
        }
        LabRig rig = LabRig.exact();
        ActLabs.place(rig, "aibo", NEAR_A_WALL);
        return rig.withAllRobots();
    }
}
