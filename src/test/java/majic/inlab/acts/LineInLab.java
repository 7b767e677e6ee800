package majic.inlab.acts;

import static org.assertj.core.api.Assertions.assertThat;

import majic.bot.Pose;
import majic.inlab.LabRig;

/**
 * The straight piece of tape in the standard room along which the tests of line followers let a Hemisson drive to an
 * obstacle.
 */
public final class LineInLab {
    /** Beside the left edge of the tape, with the ground sensors almost above it. */
    public static final Pose BESIDE_IT = new Pose(-2400, -2595, 0);

    /** Where a Pioneer is in the way. */
    public static final Pose OBSTACLE = new Pose(-1800, -2600, 0);

    /** The largest distance from the middle of the tape that a follower of its edge needs. */
    public static final double WIDEST_MM = 30;

    private static final double TAPE_Y_MM = -2600;

    private LineInLab() {}

    public static double offTheLineMm(LabRig rig) {
        return Math.abs(rig.truePose("hemisson").yMm() - TAPE_Y_MM);
    }

    /** Also checks that the robot is stationary and has touched nothing. */
    public static void assertIsAtTheObstacle(LabRig rig) throws InterruptedException {
        Pose end = rig.truePose("hemisson");
        assertThat(end.distanceMm(BESIDE_IT)).isBetween(150.0, 350.0);
        rig.lab().time().sleep(1);
        assertThat(rig.truePose("hemisson").distanceMm(end)).isLessThan(5);
        assertThat(ActLabs.bumps(rig)).containsEntry("hemisson", 0);
    }
}
