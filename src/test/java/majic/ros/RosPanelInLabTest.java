package majic.ros;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import javax.swing.JComponent;
import javax.swing.JTable;
import majic.bot.BotException;
import majic.bot.BotType.ReplayDisplay;
import majic.bot.MajicBot;
import majic.inlab.LabRig;
import majic.inlab.LabRobot;
import majic.inlab.LaidOutPanel;
import majic.panel.RefreshingPanel;
import majic.text.MarkedTexts;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The panel of the simulated ROS robot, laid out without a display. */
class RosPanelInLabTest {
    /** Values, and what the robot calls itself. */
    private static final Pattern DATA = Pattern.compile("\\b(mm|mm/s|s|clear|TurtleBot3 Burger|ROS 2|discharging)\\b");

    @BeforeEach
    void lookAsInTheProgram() throws Exception {
        LaidOutPanel.lookAsInTheProgram();
    }

    private static List<String> column(LaidOutPanel panel, int column) {
        JTable table = panel.visible(JTable.class).get(0);
        return IntStream.range(0, table.getRowCount())
                .mapToObj(row -> (String) table.getValueAt(row, column))
                .toList();
    }

    @ParameterizedTest(name = "ROS {0}")
    @ValueSource(strings = {"1", "2", "2+namespace=tb3_0"})
    void thePanelShowsWhatTheRobotReports(String model) throws Exception {
        try (LabRig lab = LabRig.exactWithRos(model)) {
            MajicBot bot = lab.add("ros");
            lab.run("1 move 200", "wait 2s");
            LaidOutPanel panel = LaidOutPanel.of(bot, 900, 700);

            assertThat(panel.text("x")).isEqualTo(bot.get("x").toString());
            assertThat(panel.text("model")).startsWith("TurtleBot3 Burger");
            assertThat(panel.text("scanner")).isEqualTo("scan ok");
            assertThat(panel.text("contacts")).isEqualTo("no contact");
            assertThat(panel.text("battery")).contains("V", "%");
            assertThat(panel.text("link")).matches("link \\d+/s");
            assertThat(column(panel, 0)).isSorted().anyMatch(topic -> topic.endsWith("/odom"));
            assertThat(column(panel, 1)).contains("Odometry", "LaserScan");
            assertThat(column(panel, 2)).contains("0.0 s");
        }
    }

    @Test
    void aContactAndALostLinkAreShown() throws Exception {
        try (LabRobot robot = new LabRobot("ros", LabRig.exactWithRos("1")).at(3500, 0, 0)) {
            robot.bot().connect();
            robot.block();
            assertThatThrownBy(() -> robot.bot().move(300)).isInstanceOf(BotException.class);
            assertThat(LaidOutPanel.of(robot.bot(), 900, 700).text("contacts")).startsWith("bump");

            robot.cut();
            while (robot.bot().isConnected()) {
                robot.bot().time().sleep(0.1);
            }
            assertThat(LaidOutPanel.of(robot.bot(), 900, 700).text("link")).isEqualTo("link lost");
        }
    }

    @Test
    void aReplayShowsTheTextsOfThePanel() throws Exception {
        try (LabRig lab = LabRig.exactWithRos("2")) {
            MajicBot bot = lab.add("ros");
            lab.run("1 move 200", "wait 2s");
            Map<String, String> state = bot.displayState();
            LaidOutPanel live = LaidOutPanel.of(bot, 900, 700);

            LaidOutPanel replayed = LaidOutPanel.of(() -> replay(bot, state), 900, 700);
            for (String name : List.of("scanner", "contacts", "battery", "link")) {
                assertThat(replayed.text(name)).as(name).isEqualTo(live.text(name));
            }
            assertThat(column(replayed, 0)).isEqualTo(column(live, 0));
        }
    }

    private static JComponent replay(MajicBot bot, Map<String, String> state) {
        ReplayDisplay replay = new RosType().replay(bot);
        replay.show(state, bot.time().nanos());
        RefreshingPanel panel = (RefreshingPanel) replay.component();
        panel.addNotify();
        panel.refreshIfChanged();
        panel.removeNotify();
        return panel;
    }

    @ParameterizedTest
    @CsvSource({"320, 240", "380, 200", "470, 260", "800, 600", "400, 700"})
    void nothingIsCutOffOrCovered(int width, int height) throws Exception {
        try (LabRig lab = LabRig.exactWithRos("2")) {
            LaidOutPanel panel = LaidOutPanel.of(lab.add("ros"), width, height);
            panel.checkThatNothingIsCovered();
            panel.checkThatNoTextIsCut(1);
        }
    }

    @Test
    void everyPartHasANameAndEnoughContrastInBothLooks() throws Exception {
        try (LabRig lab = LabRig.exactWithRos("2")) {
            LaidOutPanel.checkNamesAndContrast(List.of(lab.add("ros")), 900, 700);
        }
    }

    @Test
    @SuppressWarnings("try")
    void everyTextIsFromAResourceBundle() throws Exception {
        Locale before = Locale.getDefault();
        try (MarkedTexts marked = new MarkedTexts();
                LabRig lab = LabRig.exactWithRos("2")) {
            Locale.setDefault(marked.language());
            assertThat(LaidOutPanel.of(lab.add("ros"), 900, 700).unmarked(DATA)).isEmpty();
        } finally {
            Locale.setDefault(before);
        }
    }
}
