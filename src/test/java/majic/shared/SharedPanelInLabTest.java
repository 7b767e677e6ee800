package majic.shared;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import java.util.Objects;
import java.util.stream.Collectors;
import javax.swing.JComponent;
import majic.bot.BotType.ReplayDisplay;
import majic.bot.MajicBot;
import majic.inlab.LaidOutPanel;
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
        LaidOutPanel.lookAsInTheProgram();
    }

    private static LaidOutPanel panel(MajicBot bot) throws Exception {
        return LaidOutPanel.of(bot, 900, 700);
    }

    /** Returns the text of the banner; empty while it is hidden. */
    private static String banner(LaidOutPanel panel) {
        return panel.visible(Banner.class).stream().map(Banner::getText).collect(Collectors.joining());
    }

    @Test
    void showsWhatTheDeskReports() throws Exception {
        TwoDesks.Desk anna = desks.user("desk1", "Anna");
        anna.run("1 move 200");
        desks.pass(1);

        LaidOutPanel panel = panel(anna.bot);

        assertThat(panel.text("x")).isEqualTo(anna.bot.get("x").toString());
        assertThat(panel.text("distanceFront"))
                .isEqualTo(anna.bot.get("distanceFront").toString());
        assertThat(panel.text("battery")).contains("V");
        assertThat(panel.text("holder")).isEqualTo("held by you");
        assertThat(panel.text("link")).matches("link \\d+ ms");
    }

    @Test
    void showsTheNameOfAnotherHolderAndALostLink() throws Exception {
        TwoDesks.Desk anna = desks.user("desk1", "Anna");
        TwoDesks.Desk carl = desks.user("desk3", "Carl");
        carl.run("1 hold");
        desks.pass(0.5);
        assertThat(panel(anna.bot).text("holder")).isEqualTo("Carl at desk3");

        anna.connection().cut();
        desks.pass(3.5);

        assertThat(panel(anna.bot).text("link")).isEqualTo("link lost");
    }

    @Test
    void showsHowOldTheValuesAreUntilTheLostDeskIsUsedAgain() throws Exception {
        TwoDesks.Desk anna = desks.user("desk1", "Anna");
        desks.pass(1);
        assertThat(banner(panel(anna.bot))).isEmpty();

        desks.ofDesk2.get(0).unplug();
        desks.pass(4);
        assertThat(banner(panel(anna.bot))).matches("Not connected: all values are [45] s old\\.");
        assertThat(panel(anna.bot).label("distanceFront").isEnabled()).isFalse();
        desks.pass(20);
        assertThat(banner(panel(anna.bot))).matches("Not connected: all values are 2[45] s old\\.");

        desks.ofDesk2.get(0).restore();
        desks.pass(3);
        anna.bot.connect();
        assertThat(banner(panel(anna.bot))).isEmpty();
        assertThat(panel(anna.bot).label("distanceFront").isEnabled()).isTrue();
        assertThat(anna.bot.time().secondsSince(anna.bot.state().atNanos())).isLessThan(1.2);
    }

    @Test
    void showsHowOldTheValuesAreWhileTheDeskHasLostItsRobot() throws Exception {
        TwoDesks.Desk anna = desks.user("desk1", "Anna");
        desks.pass(1);

        desks.desk2.lab().simulators().faults("pioneer").cut();
        desks.pass(30);

        assertThat(banner(panel(anna.bot))).matches("Not connected: all values are (29|30) s old\\.");
        assertThat(panel(anna.bot).label("distanceFront").isEnabled()).isFalse();
    }

    @Test
    void isShownAgainByAReplay() throws Exception {
        TwoDesks.Desk anna = desks.user("desk1", "Anna");
        anna.run("1 hold");
        desks.pass(0.5);
        Map<String, String> recorded = anna.bot.displayState();

        assertThat(anna.bot.type().replayedBy()).isEqualTo("mqtt");
        LaidOutPanel panel = LaidOutPanel.of(() -> replay(anna, recorded), 900, 700);
        desks.pass(0.5);

        assertThat(recorded)
                .containsEntry("holder", "Anna at desk1")
                .containsEntry("address", "mqtt://broker/lab/desk2/1");
        assertThat(panel.text("holder")).isEqualTo("held by you");
        assertThat(panel.text("distanceFront"))
                .isEqualTo(desks.pioneer.get("distanceFront").toString());
    }

    private JComponent replay(TwoDesks.Desk desk, Map<String, String> recorded) {
        ReplayDisplay replay = Objects.requireNonNull(desk.bot.type().replay(desks.pioneer));
        replay.show(recorded, 0);
        RefreshingPanel panel = (RefreshingPanel) replay.component();
        panel.addNotify();
        panel.refreshIfChanged();
        panel.removeNotify();
        return panel;
    }
}
