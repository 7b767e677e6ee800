package majic.nav;

import java.util.Random;
import majic.bot.MajicBot;
import majic.bot.Pose;
import majic.bot.RangeSensor;

/**
 * Decides when a robot may turn on the spot beside something that is not on the map, such as a robot of another team.
 * Two robots that turn at the same time touch each other with corners that neither has seen where they come to be. So a
 * robot waits until what is beside it has been still for a random time, and turns alone; from what it would strike it
 * drives away first. The echo of a sonar does not say where something is well enough; a robot without a laser turns at
 * once. Used by the thread that drives the robot.
 */
final class TurningRoom {
    /** What is farther outside of the circle that the robot turns in is not beside it. */
    private static final double BESIDE_MM = 250;

    /** What is nearer to the circle than this would be struck. */
    private static final double STRUCK_MM = 10;

    /** From something that is as far outside of the circle the corners of both stay apart, whoever turns. */
    private static final double LEFT_MM = 180;

    /** Something that would be struck may go away by itself for this time longer than the random one, seconds. */
    private static final double LEAVING_S = 2;

    /** A smaller change of the distance is noise. */
    private static final double STILL_MM = 20;

    private static final double LEAST_S = 0.3;
    private static final double RANDOM_S = 2;

    private final MajicBot robot;
    private final LocalSpace local;
    private final Random random;
    private final boolean seesSharply;
    private double nearestMm = Double.POSITIVE_INFINITY;
    private double stillSinceS;
    private double patienceS;
    private boolean leaving;

    TurningRoom(MajicBot robot, LocalSpace local) {
        this.robot = robot;
        this.local = local;
        this.seesSharply = robot.rangeSensors().stream().anyMatch(RangeSensor::isLaser);
        this.random = new Random(robot.name().hashCode() + robot.time().nanos());
    }

    /** Whether the robot may turn now; if not, it stands and asks again. */
    boolean allows(Pose here) {
        if (!seesSharply) {
            return true;
        }
        if (!local.hasScanned()) {
            return false;
        }
        double circleMm = robot.profile().bodyMm();
        double nowMm = local.nearestUnknownMm(here);
        if (nowMm > circleMm + BESIDE_MM) {
            return turns();
        }
        double nowS = robot.time().nanos() / 1e9;
        if (!(Math.abs(nowMm - nearestMm) < STILL_MM)) {
            nearestMm = nowMm;
            stillSinceS = nowS;
            patienceS = LEAST_S + RANDOM_S * random.nextDouble();
        }
        double stillS = nowS - stillSinceS;
        if (nowMm < circleMm + (leaving ? LEFT_MM : STRUCK_MM)) {
            leaving |= stillS > patienceS + LEAVING_S;
            return false;
        }
        leaving = false;
        return stillS >= patienceS && turns();
    }

    private boolean turns() {
        nearestMm = Double.POSITIVE_INFINITY;
        leaving = false;
        return true;
    }

    /** Whether the robot is to drive straight away from what it would strike in a turn. */
    boolean hasToLeave() {
        return leaving;
    }

    /** Takes note that there is no room to drive farther away. */
    void cannotLeave() {
        leaving = false;
    }
}
