package majic.shared.desk;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import majic.bot.FakeBot;
import majic.bot.Pose;
import majic.bot.RangeScan;
import majic.bot.RangeSensor;
import majic.shared.message.RequestedAction;
import majic.shared.message.ScanMessage;
import majic.shared.message.SiteTopics.Part;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Tests when a desk publishes what the range sensors of its robots measure. */
class SharedScansTest {
    private static final RangeSensor LASER = RangeSensor.laser(Pose.START, 3, -1, 1, 8000, 10);

    @AutoClose
    private final SharingRig rig = SharingRig.started();

    private final FakeBot bot = rig.bot();
    private final RemoteUser anna = rig.user("desk1", "Anna");

    @BeforeEach
    void addALaser() {
        bot.equip(LASER);
    }

    /** Lets the robot measure ten times a second. */
    private void measureFor(double seconds) {
        for (int scan = 0; scan < seconds * 10; scan++) {
            measure(0);
            rig.sleep(0.1);
        }
    }

    private void measure(double ageS) {
        bot.measure(new RangeScan(
                LASER, bot.time().nanos() / 1e9 - ageS, new Pose(100, 0, 0), 500, Float.POSITIVE_INFINITY, Float.NaN));
    }

    private List<ScanMessage> scans() {
        return rig.broker.published(anna.topic(1, Part.SCANS)).stream()
                .map(message -> ScanMessage.parse(message.payload()))
                .toList();
    }

    private void askForScans() {
        anna.outcome(anna.ask(new RequestedAction.Scans()));
    }

    @Test
    void nothingIsPublishedWithoutARequest() {
        measureFor(1);

        assertThat(bot.isAskedForScans()).isFalse();
        assertThat(scans()).isEmpty();
    }

    @Test
    void whileSomebodyAsksFiveScansASecondArePublished() {
        askForScans();
        measureFor(2);

        assertThat(scans()).hasSizeBetween(8, 11);
        assertThat(scans()).allSatisfy(scan -> {
            assertThat(scan.sensor()).isEqualTo("laser");
            assertThat(scan.odometry()).isEqualTo(new Pose(100, 0, 0));
            assertThat(scan.rangesMm()).containsExactly(500, ScanMessage.NO_ECHO, ScanMessage.NOTHING_MEASURED);
        });
    }

    @Test
    void someSecondsAfterTheLastRequestNothingIsPublishedAnyMore() {
        askForScans();
        measureFor(2);
        askForScans();
        rig.sleep(3);
        assertThat(bot.isAskedForScans()).isTrue();
        rig.sleep(2);

        assertThat(bot.isAskedForScans()).isFalse();
        int before = scans().size();
        measureFor(1);
        assertThat(scans()).hasSize(before);
    }

    @Test
    void aRobotThatIsRemovedIsNotAskedAnyMore() {
        askForScans();
        assertThat(bot.isAskedForScans()).isTrue();

        rig.team.remove(1);

        assertThat(bot.isAskedForScans()).isFalse();
    }

    @Test
    void anOldScanIsNotPublished() {
        askForScans();
        measure(1.5);
        rig.sleep(0.5);

        assertThat(scans()).isEmpty();
    }
}
