package majic.pioneer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import majic.bot.MajicBot;
import majic.bot.Pose;
import majic.bot.RangeScan;
import majic.bot.RangeSensor;
import majic.bot.ScanListener;
import majic.inlab.LabRig;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

/** The scans of the lab's Pioneer, which looks along x, at the origin of the room. */
class RangesInLabTest {
    private static final double WALL_AHEAD_MM = 4500;
    private static final double DISC_AHEAD_MM = 166;

    @AutoClose
    private final LabRig rig = LabRig.exact();

    private final MajicBot bot = rig.add("pioneer");
    private final List<RangeScan> scans = new CopyOnWriteArrayList<>();
    private final ScanListener listener = scans::add;

    @Test
    void sonarsMeasureTheWallAhead() throws InterruptedException {
        bot.addScanListener(listener);
        rig.await(() -> count(3) > 0 && count(4) > 0);

        assertThat(bot.rangeSensors()).extracting(RangeSensor::name).containsExactly("sonar");
        assertThat(scans).allSatisfy(scan -> {
            assertThat(scan.sensor()).isSameAs(bot.rangeSensors().get(0));
            assertThat(scan.rangeMm(3)).matches(RangesInLabTest::isTheWall);
            assertThat(scan.rangeMm(4)).matches(RangesInLabTest::isTheWall);
            assertThat(scan.timeS()).isBetween(0.0, bot.time().nanos() / 1e9);
        });
    }

    private long count(int disc) {
        return scans.stream().filter(scan -> !Float.isNaN(scan.rangeMm(disc))).count();
    }

    private static boolean isTheWall(float mm) {
        return Float.isNaN(mm) || Math.abs(mm - (WALL_AHEAD_MM - DISC_AHEAD_MM)) <= 2;
    }

    @Test
    void theOdometryOfAScanDoesNotJumpWhenTheRobotIsPlaced() throws InterruptedException {
        bot.addScanListener(listener);
        bot.place(new Pose(3000, -2000, 90));
        bot.move(400);

        Pose last = scans.get(scans.size() - 1).odometry();
        assertThat(last.xMm()).isCloseTo(400, within(20.0));
        assertThat(last.yMm()).isCloseTo(0, within(5.0));
        assertThat(bot.state().pose().yMm()).isCloseTo(-1600, within(20.0));
    }

    @Test
    void afterTheLastListenerThereIsNoScanAndNoSonarIsSwitchedOn() throws InterruptedException {
        rig.run("1 set sonarPower off");
        bot.addScanListener(listener);
        rig.run("wait 1s");
        assertThat(scans).isEmpty();

        rig.run("1 set sonarPower on", "wait 1s");
        assertThat(scans).isNotEmpty();
        bot.removeScanListener(listener);
        rig.run("wait 0.3s");
        int before = scans.size();
        rig.run("wait 1s");
        assertThat(scans).hasSize(before);
    }
}
