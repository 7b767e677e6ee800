package majic.pioneer.session;

import java.util.function.Consumer;
import majic.bot.BotException;
import majic.bot.Motion;
import majic.bot.MotionFailed;
import majic.pioneer.arcos.ArcosCommand;
import majic.time.TimeSource;

/** Switches the motors on before a motion, with a notice to the user. For one session. */
public final class MotorPower {
    private static final double ON_S = 1;

    private final ArcosLine line;
    private final ReportedState state;
    private final TimeSource time;
    private final Consumer<String> notice;
    private volatile long requestedNanos;

    MotorPower(ArcosLine line, ReportedState state, TimeSource time, Consumer<String> notice) {
        this.line = line;
        this.state = state;
        this.time = time;
        this.notice = notice;
    }

    /**
     * Switches the motors on before a motion and waits until the robot reports them on: it ignores motion before that.
     *
     * @throws MotionFailed if they are not on within 1 s
     */
    public void switchOn(Motion motion) {
        if (state.get().motorsOn()) {
            return;
        }
        motion.send(this::request);
        if (!motion.await(() -> state.get().motorsOn(), ON_S) && !motion.guardReached()) {
            throw new MotionFailed("the motors do not switch on; is the STOP button on the robot pressed?");
        }
    }

    /** Switches the motors on without waiting, for a drive; sends the command at most once a second. */
    void switchOnWithoutWaiting() {
        boolean requested = requestedNanos != 0 && time.secondsSince(requestedNanos) < ON_S;
        if (!state.get().motorsOn() && !requested) {
            request();
        }
    }

    private void request() {
        if (state.get().stopButton()) {
            throw new BotException("the STOP button on the robot is pressed");
        }
        requestedNanos = time.nanos();
        line.send(ArcosCommand.ENABLE.packet(1));
        notice.accept("motors on");
    }
}
