package majic.ros;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.formdev.flatlaf.FlatDarkLaf;
import com.formdev.flatlaf.FlatLaf;
import com.formdev.flatlaf.FlatLightLaf;
import java.awt.Component;
import java.awt.Container;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.function.Predicate;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JTable;
import javax.swing.SwingUtilities;
import javax.swing.UIManager;
import majic.bot.BotException;
import majic.bot.BotType.ReplayDisplay;
import majic.bot.MajicBot;
import majic.gui.Contrast;
import majic.gui.WindowAudit;
import majic.inlab.LabRig;
import majic.inlab.LabRobot;
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
        SwingUtilities.invokeAndWait(FlatLightLaf::setup);
    }

    private static JComponent panel(MajicBot bot, int width, int height) throws Exception {
        JComponent[] made = new JComponent[1];
        SwingUtilities.invokeAndWait(() -> {
            made[0] = Objects.requireNonNull(bot.display());
            made[0].setSize(width, height);
            layOut(made[0]);
        });
        return made[0];
    }

    private static void layOut(Container container) {
        container.doLayout();
        Stream.of(container.getComponents())
                .filter(Container.class::isInstance)
                .forEach(inner -> layOut((Container) inner));
    }

    private static <T> List<T> visible(Container container, Class<T> kind) {
        List<T> found = new ArrayList<>();
        for (Component child : container.getComponents()) {
            if (child.isVisible() && kind.isInstance(child)) {
                found.add(kind.cast(child));
            } else if (child.isVisible() && child instanceof Container inner) {
                found.addAll(visible(inner, kind));
            }
        }
        return found;
    }

    private static String shown(JComponent panel, String name) {
        return visible(panel, JLabel.class).stream()
                .filter(label -> name.equals(label.getName()))
                .map(JLabel::getText)
                .findFirst()
                .orElseThrow();
    }

    private static List<String> column(JComponent panel, int column) {
        JTable table = visible(panel, JTable.class).get(0);
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
            JComponent panel = panel(bot, 900, 700);

            assertThat(shown(panel, "x")).isEqualTo(bot.get("x").toString());
            assertThat(shown(panel, "model")).startsWith("TurtleBot3 Burger");
            assertThat(shown(panel, "scanner")).isEqualTo("scan ok");
            assertThat(shown(panel, "contacts")).isEqualTo("no contact");
            assertThat(shown(panel, "battery")).contains("V", "%");
            assertThat(shown(panel, "link")).matches("link \\d+/s");
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
            assertThat(shown(panel(robot.bot(), 900, 700), "contacts")).startsWith("bump");

            robot.cut();
            while (robot.bot().isConnected()) {
                robot.bot().time().sleep(0.1);
            }
            assertThat(shown(panel(robot.bot(), 900, 700), "link")).isEqualTo("link lost");
        }
    }

    @Test
    void aReplayShowsTheTextsOfThePanel() throws Exception {
        try (LabRig lab = LabRig.exactWithRos("2")) {
            MajicBot bot = lab.add("ros");
            lab.run("1 move 200", "wait 2s");
            Map<String, String> state = bot.displayState();
            JComponent live = panel(bot, 900, 700);

            ReplayDisplay[] replay = new ReplayDisplay[1];
            SwingUtilities.invokeAndWait(() -> replay[0] = new RosType().replay(bot));
            replay[0].show(state, bot.time().nanos());
            SwingUtilities.invokeAndWait(() -> {
                JComponent panel = replay[0].component();
                ((RefreshingPanel) panel).addNotify();
                ((RefreshingPanel) panel).refreshIfChanged();
                panel.setSize(900, 700);
                layOut(panel);
                for (String name : List.of("scanner", "contacts", "battery", "link")) {
                    assertThat(shown(panel, name)).as(name).isEqualTo(shown(live, name));
                }
                assertThat(column(panel, 0)).isEqualTo(column(live, 0));
                panel.removeNotify();
            });
        }
    }

    @ParameterizedTest
    @CsvSource({"320, 240", "380, 200", "470, 260", "800, 600", "400, 700"})
    void nothingIsCutOffOrCovered(int width, int height) throws Exception {
        try (LabRig lab = LabRig.exactWithRos("2")) {
            JComponent panel = panel(lab.add("ros"), width, height);
            Component map = panel.getComponent(0);
            assertThat(Math.min(map.getWidth(), map.getHeight())).isGreaterThan(90);
            assertThat(Stream.of(panel.getComponents()).skip(1).filter(Component::isVisible))
                    .allSatisfy(part -> {
                        assertThat(map.getBounds().intersects(part.getBounds())).isFalse();
                        assertThat(panel.getBounds().contains(part.getBounds())).isTrue();
                    });
            Predicate<JLabel> isCut = label -> label.getPreferredSize().width > label.getWidth();
            assertThat(visible(panel, JLabel.class).stream().filter(isCut).map(JLabel::getText))
                    .isEmpty();
        }
    }

    @Test
    void everyPartHasANameAndEnoughContrastInBothLooks() throws Exception {
        try (LabRig lab = LabRig.exactWithRos("2")) {
            MajicBot bot = lab.add("ros");
            for (FlatLaf look : List.of(new FlatDarkLaf(), new FlatLightLaf())) {
                SwingUtilities.invokeAndWait(() -> FlatLaf.setup(look));
                JComponent panel = panel(bot, 900, 700);
                SwingUtilities.invokeAndWait(() -> {
                    panel.setBackground(UIManager.getColor("Panel.background"));
                    assertThat(WindowAudit.nameless(panel)).isEmpty();
                    assertThat(WindowAudit.pale(panel, Contrast.TEXT)).isEmpty();
                });
            }
        }
    }

    @Test
    @SuppressWarnings("try")
    void everyTextIsFromAResourceBundle() throws Exception {
        Locale before = Locale.getDefault();
        try (MarkedTexts marked = new MarkedTexts();
                LabRig lab = LabRig.exactWithRos("2")) {
            Locale.setDefault(marked.language());
            MajicBot bot = lab.add("ros");
            JComponent panel = panel(bot, 900, 700);
            List<String> unmarked = new ArrayList<>();
            SwingUtilities.invokeAndWait(() -> unmarked.addAll(WindowAudit.unmarked(panel, DATA)));
            assertThat(unmarked).isEmpty();
        } finally {
            Locale.setDefault(before);
        }
    }
}
