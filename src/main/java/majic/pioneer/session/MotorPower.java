package majic.pioneer.session;

import java.util.function.Consumer;
import majic.bot.BotException;
import majic.bot.Motion;
import majic.bot.MotionFailed;
import majic.pioneer.arcos.ArcosCommand;
import majic.time.TimeSource;

/** Switches the motors on when something is to move, and says so. For one session. */
public final class MotorPower {
    private static final double ON_S = 1;

    private final ArcosLine line;
    private final ReportedState state;
    private final TimeSource time;
    private final Consumer<String> notice;
    private volatile long askedNanos;

    MotorPower(ArcosLine line, ReportedState state, TimeSource time, Consumer<String> notice) {
        this.line = line;
        this.state = state;
        this.time = time;
        this.notice = notice;
    }

    /**
     * Makes sure that they are on before a motion, waiting for the robot to say so: it ignores motion before.
     *
     * @throws MotionFailed if they do not come on
     */
    public void switchOn(Motion motion) {
        if (state.get().motorsOn()) {
            return;
        }
        motion.send(this::ask);
        if (!motion.await(() -> state.get().motorsOn(), ON_S) && !motion.guardReached()) {
            throw new MotionFailed("the motors do not switch on; is the STOP button on the robot pressed?");
        }
    }

    /** Asks for them before a command that waits for nothing, once a second at most. */
    void switchOnSoon() {
        boolean asked = askedNanos != 0 && time.secondsSince(askedNanos) < ON_S;
        if (!state.get().motorsOn() && !asked) {
            ask();
        }
    }

    private void ask() {
        if (state.get().stopButton()) {
            throw new BotException("the STOP button on the robot is pressed");
        }
        askedNanos = time.nanos();
        line.send(ArcosCommand.ENABLE.packet(1));
        notice.accept("motors on");
    }
}
