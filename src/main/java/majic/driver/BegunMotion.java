package majic.driver;

import majic.bot.BotException;
import majic.bot.MotionReport;

/**
 * A motion that one thread has begun, for which no other motion of the robot may begin, and which another thread
 * finishes. {@link #finish} must follow, also when the motion was stopped meanwhile.
 */
public final class BegunMotion {
    private final MotionGate gate;
    private final Motion motion;
    private final Permit permitOfRobot;
    private final MotionGate.Maneuver maneuver;

    /**
     * @param permitOfRobot the permit of the robot itself that was in force when the motion began
     */
    BegunMotion(MotionGate gate, Motion motion, Permit permitOfRobot, MotionGate.Maneuver maneuver) {
        this.gate = gate;
        this.motion = motion;
        this.permitOfRobot = permitOfRobot;
        this.maneuver = maneuver;
    }

    Motion motion() {
        return motion;
    }

    Permit permitOfRobot() {
        return permitOfRobot;
    }

    MotionGate.Maneuver maneuver() {
        return maneuver;
    }

    /**
     * Goes on with the motion until it has ended. To be called once.
     *
     * @return how far it went
     * @throws BotException as a motion that was not begun before
     */
    public MotionReport finish() {
        return gate.finish(this);
    }
}
