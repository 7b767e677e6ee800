package majic.shared;

import static org.assertj.core.api.Assertions.assertThat;

import com.formdev.flatlaf.FlatLightLaf;
import java.awt.Component;
import java.awt.Container;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.SwingUtilities;
import majic.bot.BotType.ReplayDisplay;
import majic.bot.MajicBot;
import majic.panel.Banner;
import majic.panel.RefreshingPanel;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Tests the panel of a shared robot, laid out without a display. */
class SharedPanelInLabTest {
    @AutoClose
    private final TwoDesks desks = new TwoDesks();

    @BeforeEach
    void lookAsInTheProgram() throws Exception {
        SwingUtilities.invokeAndWait(FlatLightLaf::setup);
    }

    private static JComponent panel(MajicBot bot) throws Exception {
        JComponent[] made = new JComponent[1];
        SwingUtilities.invokeAndWait(() -> {
            made[0] = Objects.requireNonNull(bot.display());
            layOut(made[0]);
        });
        return made[0];
    }

    private static void layOut(JComponent panel) {
        panel.setSize(900, 700);
        layOutAll(panel);
    }

    private static void layOutAll(Container container) {
        container.doLayout();
        Stream.of(container.getComponents())
                .filter(Container.class::isInstance)
                .forEach(inner -> layOutAll((Container) inner));
    }

    private static List<JLabel> labels(Container container) {
        List<JLabel> found = new ArrayList<>();
        for (Component child : container.getComponents()) {
            if (child.isVisible() && child instanceof JLabel label) {
                found.add(label);
            } else if (child.isVisible() && child instanceof Container inner) {
                found.addAll(labels(inner));
            }
        }
        return found;
    }

    private static String shown(JComponent panel, String name) {
        return label(panel, name).getText();
    }

    private static JLabel label(JComponent panel, String name) {
        return labels(panel).stream()
                .filter(label -> name.equals(label.getName()))
                .findFirst()
                .orElseThrow();
    }

    /** Returns the text of the banner; empty while it is hidden. */
    private static String banner(JComponent panel) {
        return Stream.of(panel.getComponents())
                .filter(Banner.class::isInstance)
                .map(Banner.class::cast)
                .filter(Banner::isVisible)
                .map(Banner::getText)
                .collect(Collectors.joining());
    }

    @Test
    void showsWhatTheDeskReports() throws Exception {
        TwoDesks.Desk anna = desks.user("desk1", "Anna");
        anna.run("1 move 200");
        desks.pass(1);

        JComponent panel = panel(anna.bot);

        assertThat(shown(panel, "x")).isEqualTo(anna.bot.get("x").toString());
        assertThat(shown(panel, "distanceFront"))
                .isEqualTo(anna.bot.get("distanceFront").toString());
        assertThat(shown(panel, "battery")).contains("V");
        assertThat(shown(panel, "holder")).isEqualTo("held by you");
        assertThat(shown(panel, "link")).matches("link \\d+ ms");
    }

    @Test
    void showsTheNameOfAnotherHolderAndALostLink() throws Exception {
        TwoDesks.Desk anna = desks.user("desk1", "Anna");
        TwoDesks.Desk carl = desks.user("desk3", "Carl");
        carl.run("1 hold");
        desks.pass(0.5);
        assertThat(shown(panel(anna.bot), "holder")).isEqualTo("Carl at desk3");

        anna.connection().cut();
        desks.pass(3.5);

        assertThat(shown(panel(anna.bot), "link")).isEqualTo("link lost");
    }

    @Test
    void showsHowOldTheValuesAreUntilTheLostDeskIsUsedAgain() throws Exception {
        TwoDesks.Desk anna = desks.user("desk1", "Anna");
        desks.pass(1);
        assertThat(banner(panel(anna.bot))).isEmpty();

        desks.ofDesk2.get(0).unplug();
        desks.pass(4);
        assertThat(banner(panel(anna.bot))).matches("Not connected: all values are [45] s old\\.");
        assertThat(label(panel(anna.bot), "distanceFront").isEnabled()).isFalse();
        desks.pass(20);
        assertThat(banner(panel(anna.bot))).matches("Not connected: all values are 2[45] s old\\.");

        desks.ofDesk2.get(0).restore();
        desks.pass(3);
        anna.bot.connect();
        assertThat(banner(panel(anna.bot))).isEmpty();
        assertThat(label(panel(anna.bot), "distanceFront").isEnabled()).isTrue();
        assertThat(anna.bot.time().secondsSince(anna.bot.state().atNanos())).isLessThan(1.2);
    }

    @Test
    void showsHowOldTheValuesAreWhileTheDeskHasLostItsRobot() throws Exception {
        TwoDesks.Desk anna = desks.user("desk1", "Anna");
        desks.pass(1);

        desks.desk2.lab().simulators().faults("pioneer").cut();
        desks.pass(30);

        assertThat(banner(panel(anna.bot))).matches("Not connected: all values are (29|30) s old\\.");
        assertThat(label(panel(anna.bot), "distanceFront").isEnabled()).isFalse();
    }

    @Test
    void isShownAgainByAReplay() throws Exception {
        TwoDesks.Desk anna = desks.user("desk1", "Anna");
        anna.run("1 hold");
        desks.pass(0.5);
        Map<String, String> recorded = anna.bot.displayState();

        assertThat(anna.bot.type().replayedBy()).isEqualTo("mqtt");
        JComponent[] panel = new JComponent[1];
        SwingUtilities.invokeAndWait(() -> {
            ReplayDisplay replay = Objects.requireNonNull(anna.bot.type().replay(desks.pioneer));
            replay.show(recorded, 0);
            panel[0] = replay.component();
            panel[0].addNotify();
            ((RefreshingPanel) panel[0]).refreshIfChanged();
            panel[0].removeNotify();
            layOut(panel[0]);
        });
        desks.pass(0.5);

        assertThat(recorded)
                .containsEntry("holder", "Anna at desk1")
                .containsEntry("address", "mqtt://broker/lab/desk2/1");
        assertThat(shown(panel[0], "holder")).isEqualTo("held by you");
        assertThat(shown(panel[0], "distanceFront"))
                .isEqualTo(desks.pioneer.get("distanceFront").toString());
    }
}
