package majic.pioneer.state;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import majic.bot.Beam;
import majic.bot.Pose;
import majic.bot.RangeScan;
import majic.pioneer.arcos.SipBytes;
import org.junit.jupiter.api.Test;

class SonarsTest {
    private static final Model MODEL = Models.of("p3dx-sh");
    private static final long SECOND = 1_000_000_000;

    private final Sonars sonars = Sonars.of(MODEL).orElseThrow();
    private final StateTracker tracker = new StateTracker(MODEL, new Pose(100, 200, 90));

    private PioneerState track(SipBytes sip, double seconds) {
        return tracker.track(sip.sip(), (long) (seconds * SECOND));
    }

    @Test
    void eachDiscIsABeamAtItsPlace() {
        assertThat(sonars.sensor().name()).isEqualTo("sonar");
        assertThat(sonars.sensor().beams()).hasSize(16);
        Beam disc10 = sonars.sensor().beams().get(10);
        assertThat(disc10.mount()).isEqualTo(new Pose(-237, -78, -150));
        assertThat(disc10.openingDeg()).isEqualTo(30);
        assertThat(disc10.reachMm()).isEqualTo(5000);
    }

    @Test
    void aScanHasTheReadingsOfItsSipOnly() {
        track(new SipBytes().sonar(3, 900).sonar(5, 700), 1);
        RangeScan scan = sonars.scan(track(new SipBytes().sonar(3, 800).sonar(12, 5000), 1.1))
                .orElseThrow();

        assertThat(scan.rangeMm(3)).isEqualTo(800);
        assertThat(scan.rangeMm(12)).isEqualTo(Float.POSITIVE_INFINITY);
        assertThat(scan.rangeMm(5)).isNaN();
        assertThat(scan.timeS()).isCloseTo(1.1, within(1e-6));
    }

    @Test
    void aScanHasTheOdometryOfItsSip() {
        track(new SipBytes().sonar(3, 900), 1);
        RangeScan scan = sonars.scan(track(new SipBytes().pose(50, 0, 0).sonar(3, 850), 1.1))
                .orElseThrow();

        assertThat(scan.odometry().distanceMm(new Pose(100, 250, 90))).isLessThan(0.001);
    }

    @Test
    void withoutANewReadingThereIsNoScan() {
        track(new SipBytes().sonar(3, 900), 1);

        assertThat(sonars.scan(track(new SipBytes(), 1.1))).isEmpty();
        assertThat(sonars.scan(track(new SipBytes().sonar(40, 900), 1.2))).isEmpty();
    }

    @Test
    void aRobotWithOneArrayHasTheBeamsOfIts() {
        Sonars rear = Sonars.of(MODEL.with(MODEL.discs().subList(8, 16))).orElseThrow();
        RangeScan scan =
                rear.scan(track(new SipBytes().sonar(3, 900).sonar(9, 600), 1)).orElseThrow();

        assertThat(scan.size()).isEqualTo(8);
        assertThat(scan.rangeMm(1)).isEqualTo(600);
    }

    @Test
    void aModelWithoutKnownSonarsHasNoSensor() {
        assertThat(Sonars.of(Models.of("seekur"))).isEmpty();
    }
}
