package majic.hemisson.motion;

import java.util.function.Consumer;
import majic.hemisson.line.Conversation;
import majic.hemisson.line.Identity;
import majic.hemisson.line.MotorValues;
import majic.hemisson.line.Question;
import majic.hemisson.line.Reply;

/**
 * Holds the identity of the robot, which changes with a restart: the robot reads its switches again, so it may run in
 * another mode from then on (Hemisson sheet 4.3). Called by the timer thread and the reader; never blocks.
 */
final class RestartCheck {
    private final Consumer<String> notices;
    private volatile Identity identity = Identity.NONE;
    private volatile boolean modeUnknown;
    private volatile boolean restarted;

    RestartCheck(Consumer<String> notices) {
        this.notices = notices;
    }

    /** Starts with a new connection. */
    void begin() {
        modeUnknown = false;
        restarted = false;
    }

    void identified(Identity found) {
        identity = found;
    }

    Identity identity() {
        return identity;
    }

    /** Shows a warning if the running mode may move the robot. */
    void warnOfMode() {
        String warning = identity.warning();
        if (warning != null) {
            notices.accept(warning);
        }
    }

    /** Records a restart, and asks for the switches. */
    void restarted(Conversation conversation) {
        modeUnknown = true;
        restarted = true;
        conversation.ask(Question.SWITCHES);
    }

    /** Takes the switches; the first ones after a restart determine the mode. */
    void switchesRead(Reply reply, Conversation conversation) {
        if (!modeUnknown) {
            return;
        }
        modeUnknown = false;
        identity = identity.restarted(reply.numbers());
        conversation.setDeafenable(!identity.listens());
        conversation.setOwnSpeeds(identity.hasOwnSpeeds());
        warnOfMode();
    }

    /** Takes the speeds that followed a stop; the first ones after a restart are shown to the user. */
    void speedsVerified(Reply reply) {
        if (restarted) {
            restarted = false;
            boolean moves =
                    reply.kind() == Reply.Kind.ANSWER && !MotorValues.of(reply).isStill();
            notices.accept("it was switched on or reset; its LEDs are off, its motors " + (moves ? "run" : "stand"));
        }
    }
}
