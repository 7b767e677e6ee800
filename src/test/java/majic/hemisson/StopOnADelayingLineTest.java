package majic.hemisson;

import static org.assertj.core.api.Assertions.assertThat;

import majic.bot.MajicBot;
import majic.bot.Pose;
import majic.inlab.LabRig;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Lines that delay everything, as a radio link does: when a stop is confirmed, the commands to drive that were still
 * under way have been obeyed.
 */
class StopOnADelayingLineTest {
    /** A ROS robot that is silent for nearly a second counts as lost. */
    @ParameterizedTest(name = "{0}, {1} ms")
    @CsvSource({"aibo, 400", "pioneer, 400", "hemisson, 400", "ros, 200"})
    void aRobotDoesNotMoveOnceItHasConfirmed(String type, int delayMs) throws InterruptedException {
        try (LabRig rig = LabRig.exactWithRos("2")) {
            MajicBot robot = rig.add(type);
            robot.move(20);
            rig.lab().simulators().faults(type).delay(delayMs);
            robot.time().sleep(2);
            robot.drive(robot.profile().cruiseMmPerSec(), 0);
            robot.time().sleep(delayMs / 2e3);

            robot.stop();
            Pose confirmed = rig.truePose(type);
            robot.time().sleep(2);

            Pose later = rig.truePose(type);
            assertThat(Math.hypot(later.xMm() - confirmed.xMm(), later.yMm() - confirmed.yMm()))
                    .isLessThan(2);
        }
    }
}
