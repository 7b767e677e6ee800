package majic.pioneer.panel;

import static org.assertj.core.api.Assertions.assertThat;
import static org.mockito.ArgumentMatchers.anyString;
import static org.mockito.Mockito.mock;
import static org.mockito.Mockito.when;

import java.awt.Component;
import java.awt.Container;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.SwingUtilities;
import majic.bot.BotState;
import majic.bot.MajicBot;
import majic.bot.MajicBot.Connection;
import majic.bot.Pose;
import majic.bot.Range;
import majic.bot.Reading;
import majic.bot.Unit;
import majic.bot.Value;
import majic.panel.RefreshingPanel;
import majic.pioneer.arcos.PacketCounts;
import majic.pioneer.arcos.SipBytes;
import majic.pioneer.state.Bumpers;
import majic.pioneer.state.Hull;
import majic.pioneer.state.Model;
import majic.pioneer.state.Models;
import majic.pioneer.state.Scaling;
import majic.pioneer.state.SonarDisc;
import majic.pioneer.state.StateTracker;
import org.junit.jupiter.api.Test;

/** Tests the panel of a recorded Pioneer. */
class PioneerReplayTest {
    private static final long MS = 1_000_000;
    private static final Model MODEL = Models.of("p3dx-sh");

    @Test
    void showsTheRecordedPacketRateThoughSamplesWereTakenAtOtherTimes() throws Exception {
        Map<String, String> texts = PioneerReplay.texts(sceneWithRate(10.47));
        SwingUtilities.invokeAndWait(() -> {
            PioneerReplay replay = new PioneerReplay(connectedRobot());
            replay.component().addNotify();

            replay.show(texts, 100 * MS);
            replay.show(texts, 300 * MS);
            ((RefreshingPanel) replay.component()).refreshIfChanged();

            assertThat(text(replay.component(), "link")).contains("link 10/s");
        });
    }

    /** As a parameter file and a CONFIG packet change a model. */
    @Test
    void aRobotWithItsOwnScaleAndSonarsIsRecordedWithThem() {
        Model own = MODEL.with(
                new Hull(300, 200, 150), List.of(new SonarDisc(3, 1, 2, 30)), new Scaling(0.5, 0.25, 2, 0.1, 0.01));

        assertThat(PioneerReplay.model(PioneerReplay.texts(scene(own, 10)))).isEqualTo(own);
        assertThat(PioneerReplay.model(PioneerReplay.texts(scene(MODEL, 10)))).isEqualTo(MODEL);
        assertThat(PioneerReplay.texts(scene(MODEL, 10))).doesNotContainKey("scale");
    }

    private static PioneerScene sceneWithRate(double packetRate) {
        return scene(MODEL, packetRate);
    }

    private static PioneerScene scene(Model model, double packetRate) {
        return new PioneerScene(
                model,
                new StateTracker(model, Pose.START).track(new SipBytes().sip(), MS),
                Optional.empty(),
                new Bumpers(0, 0),
                Connection.CONNECTED,
                0,
                packetRate,
                PacketCounts.NONE,
                new Range(-1000, 1000),
                new Range(-100, 100));
    }

    private static MajicBot connectedRobot() {
        MajicBot bot = mock(MajicBot.class);
        when(bot.isConnected()).thenReturn(true);
        when(bot.connection()).thenReturn(Connection.CONNECTED);
        when(bot.state()).thenReturn(BotState.UNKNOWN);
        when(bot.get(anyString())).thenReturn(Value.of(0, Unit.MS));
        when(bot.reading(anyString())).thenReturn(Reading.current(Value.of(0, Unit.MS), 0));
        return bot;
    }

    private static Optional<String> text(Container parts, String name) {
        return Stream.of(parts.getComponents())
                .flatMap(part -> texts(part, name))
                .findFirst();
    }

    private static Stream<String> texts(Component part, String name) {
        if (part instanceof JLabel label && name.equals(label.getName())) {
            return Stream.of(label.getText());
        }
        return part instanceof JComponent inner ? text(inner, name).stream() : Stream.empty();
    }
}
