package majic.pioneer.panel;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.swing.SwingUtilities;
import majic.bot.FakeBot;
import majic.bot.MajicBot.Connection;
import majic.bot.Pose;
import majic.bot.Range;
import majic.bot.RangeScan;
import majic.bot.RangeSensor;
import majic.panel.RefreshingPanel;
import majic.panel.StatusLight;
import majic.panel.StatusLightsPanel;
import majic.panel.map.MapView;
import majic.pioneer.arcos.PacketCounts;
import majic.pioneer.arcos.SipBytes;
import majic.pioneer.state.Bumpers;
import majic.pioneer.state.Model;
import majic.pioneer.state.Models;
import majic.pioneer.state.PioneerState;
import majic.pioneer.state.StateTracker;
import majic.time.TimeSource;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

class PioneerDrawingTest {
    private static final int SIZE = 400;
    private static final int SONARS_ON = 0b11111;
    private static final long SECOND = 1_000_000_000;
    private static final Model MODEL = Models.of("peoplebot-sh");
    private static final MapView VIEW = new MapView(0.08, 0, 0, MapView.Y_UP, SIZE, SIZE);

    private final StateTracker tracker = new StateTracker(MODEL, Pose.START);
    private final PioneerDrawing drawing = new PioneerDrawing();
    private final PioneerLights lights = new PioneerLights();

    @BeforeEach
    void showRobotAtStart() {
        drawing.show(scene(sip(), Connection.CONNECTED));
    }

    @Test
    void aConeEndsWhereItsEchoCameFrom() {
        int[] nothing = painted();
        drawing.show(scene(sip().sonar(3, 1500), Connection.CONNECTED));
        int[] echo = painted();

        assertThat(differs(nothing, echo, MODEL.discs().get(3).echoX(1000), 150))
                .isTrue();
        assertThat(differs(nothing, echo, MODEL.discs().get(3).echoX(1900), 150))
                .isFalse();
    }

    @Test
    void echoesStayOnTheMapAndFade() {
        receive(sip().sonar(0, 1000), SECOND);
        int[] fresh = painted();
        receive(sip().pose(0, 0, 0), 100 * SECOND);
        int[] old = painted();
        drawing.clear();

        assertThat(differing(fresh, old)).isPositive();
        assertThat(differing(painted(), old)).isBetween(3L, differing(painted(), fresh));
    }

    @Test
    void theMapShowsThePathAndKeepsItVisible() {
        receive(sip(), SECOND);
        receive(sip().pose(2000, 0, 0), 2 * SECOND);

        assertThat(drawing.pose().xMm()).isCloseTo(2000, within(1.0));
        assertThat(drawing.extent().contains(0, 0)).isTrue();
        assertThat(drawing.extent().contains(2000, 0)).isTrue();
    }

    @Test
    void aTouchedBumperSegmentIsSeenWhereItSits() {
        int[] free = painted();
        drawing.show(scene(sip().state(0x0200, SONARS_ON), Connection.CONNECTED));
        int[] touched = painted();

        assertThat(differing(free, touched)).isBetween(20L, 2000L);
    }

    @Test
    void theEchoesOfALaserAreDrawnWhereTheRobotMeasuredThem() {
        RangeSensor laser = RangeSensor.laser(Pose.START, 1, 0, 1, 8000, 10);
        PioneerState state = tracker.track(sip().pose(500, 0, 0).sip(), SECOND);
        drawing.show(scene(state, Connection.CONNECTED));
        int[] without = painted();
        RangeScan scan = new RangeScan(laser, 1, Pose.START, 1500);
        drawing.show(scene(state, Optional.of(scan), Connection.CONNECTED));

        assertThat(differs(without, painted(), 1500, 0)).isTrue();
        assertThat(differing(without, painted())).isBetween(1L, 100L);
    }

    @Test
    void aLostRobotIsPaintedFadedAndWithoutCones() {
        drawing.show(scene(sip().sonar(3, 1500), Connection.CONNECTED));
        int[] connected = painted();
        drawing.show(scene(sip().sonar(3, 1500), Connection.LOST));

        assertThat(differing(connected, painted())).isGreaterThan(1000);
    }

    @Test
    void lightsShowAWordAndAKind() {
        lights.show(scene(sip().state(0x0500, SONARS_ON), Connection.CONNECTED));
        assertThat(light("motors")).isEqualTo("GOOD motors on");
        assertThat(light("bumpers")).isEqualTo("ALARM bumper F2");
        assertThat(light("stallRight")).isEqualTo("ALARM right stuck");
        assertThat(light("stallLeft")).isEqualTo("QUIET left wheel ok");

        lights.show(scene(sip().state(0, 1 << 5), Connection.LOST));
        assertThat(light("stopButton")).isEqualTo("ALARM STOP pressed");
        assertThat(light("sonars")).isEqualTo("WARNING sonars off");
        assertThat(light("link")).isEqualTo("ALARM link lost");
    }

    @Test
    void theLastReadingsAreOldUntilANewConnectionReports() throws Exception {
        FakeBot bot = FakeBot.on(TimeSource.system());
        AtomicReference<PioneerScene> reported =
                new AtomicReference<>(scene(sip().state(0, 1 << 5), Connection.CONNECTED));
        SwingUtilities.invokeAndWait(() -> {
            RefreshingPanel panel =
                    (RefreshingPanel) PioneerPanel.create(bot, () -> Optional.ofNullable(reported.get()));
            StatusLightsPanel shown = (StatusLightsPanel) panel.getComponent(2);
            assertThat(shown.getComponent(0).isEnabled()).isTrue();

            reported.set(null);
            panel.addNotify();
            panel.refreshIfChanged();
            panel.removeNotify();
            assertThat(shown.getComponent(0).isEnabled()).isFalse();
        });
    }

    private String light(String name) {
        return Stream.of(lights.panel().getComponents())
                .map(StatusLight.class::cast)
                .filter(light -> light.getName().equals(name))
                .map(light -> light.kind() + " " + light.getText())
                .findFirst()
                .orElseThrow();
    }

    private void receive(SipBytes sip, long nanos) {
        PioneerState state = tracker.track(sip.sip(), nanos);
        drawing.record(MODEL, state);
        drawing.show(scene(state, Connection.CONNECTED));
    }

    private static SipBytes sip() {
        return new SipBytes().state(0, SONARS_ON);
    }

    private PioneerScene scene(SipBytes sip, Connection connection) {
        return scene(tracker.track(sip.sip(), SECOND), connection);
    }

    private static PioneerScene scene(PioneerState state, Connection connection) {
        return scene(state, Optional.empty(), connection);
    }

    private static PioneerScene scene(PioneerState state, Optional<RangeScan> laser, Connection connection) {
        Bumpers bumpers = new Bumpers(MODEL.frontBumpers(), MODEL.rearBumpers());
        Range limits = new Range(-1000, 1000);
        return new PioneerScene(
                MODEL, state, laser, bumpers, connection, 50, state.sipsPerSec(), PacketCounts.NONE, limits, limits);
    }

    private int[] painted() {
        BufferedImage image = new BufferedImage(SIZE, SIZE, BufferedImage.TYPE_INT_RGB);
        Graphics2D pen = image.createGraphics();
        drawing.paint(pen, VIEW);
        pen.dispose();
        return image.getRGB(0, 0, SIZE, SIZE, null, 0, SIZE);
    }

    private static boolean differs(int[] one, int[] other, double xMm, double yMm) {
        int x = (int) VIEW.pixel(xMm, yMm).getX();
        int y = (int) VIEW.pixel(xMm, yMm).getY();
        return one[y * SIZE + x] != other[y * SIZE + x];
    }

    private static long differing(int[] one, int[] other) {
        return IntStream.range(0, one.length)
                .filter(index -> one[index] != other[index])
                .count();
    }
}
