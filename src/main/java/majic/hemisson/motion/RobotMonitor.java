package majic.hemisson.motion;

import java.io.IOException;
import majic.bot.BotState;
import majic.bot.LinkLost;
import majic.hemisson.line.Conversation;
import majic.hemisson.line.ConversationListener;
import majic.hemisson.line.Exchange;
import majic.hemisson.line.HemissonSession;
import majic.hemisson.line.Identity;
import majic.hemisson.line.MotorValues;
import majic.hemisson.line.Question;
import majic.hemisson.line.Reply;
import majic.hemisson.line.StopConfirmation;
import majic.hemisson.readings.PollSchedule;
import majic.hemisson.readings.PolledAnswers;
import majic.hemisson.readings.Proximity;
import majic.time.Signal;
import majic.time.TimeSource;
import org.jspecify.annotations.Nullable;

/**
 * Monitors the robot: polls it, more often while it moves, and stops it after a missed answer, a difference between the
 * speeds sent and those it reports, or an overdue motion. Called by the timer thread and the reader; never blocks.
 */
public final class RobotMonitor implements ConversationListener {
    private final Owner owner;
    private final TimeSource time;
    private final Signal changes;
    private final PolledAnswers polled;
    private final MotionWatch motion;
    private final Polling polling;
    private final PoseEstimator pose;
    private final ConnectionLoss loss;
    private final RestartCheck restarts;
    private final MotorCheck wheels = new MotorCheck();
    private volatile @Nullable HemissonSession session;
    private volatile boolean watching;

    /** The driver. Called by the timer thread and the reader; must not block. */
    public interface Owner {
        /** Whether the robot is connected, so that it is polled. */
        boolean isConnected();

        /** Whether its connection was lost, so that it is stopped until it confirms. */
        boolean isLost();

        /** Takes the estimated state of the robot. */
        void publish(BotState state);

        /** The robot was switched on or reset: its LEDs are off and its pins are inputs. */
        void wasReset();

        /** Shows a message to the user. */
        void notice(String message);

        /** Gives the connection up. */
        void lose(LinkLost cause);
    }

    /**
     * Monitors nothing yet.
     *
     * @param changes raised after each answer, for all threads that wait for one
     * @param table the speeds of the motor values
     */
    public RobotMonitor(Owner owner, TimeSource time, Signal changes, SpeedTable table) {
        this.owner = owner;
        this.time = time;
        this.changes = changes;
        this.polled = new PolledAnswers(time);
        this.motion = new MotionWatch(time.nanos());
        this.polling = new Polling(new PollSchedule(polled), motion, time);
        this.loss = new ConnectionLoss(owner::lose, owner::notice);
        this.restarts = new RestartCheck(owner::notice);
        this.pose =
                new PoseEstimator(time, table, owner::publish, () -> identity().mayMoveUnreported());
    }

    /** Starts with a new connection, before its first question. */
    public void begin(HemissonSession opened) {
        watching = false;
        restarts.begin();
        polling.begin();
        polled.forget();
        motion.begins(Long.MAX_VALUE);
        session = opened;
        pose.begin();
    }

    /** Takes the robot that answered at connecting. */
    public void identified(Identity found) {
        restarts.identified(found);
    }

    /** The robot that answered last; {@link Identity#NONE} before the first. */
    public Identity identity() {
        return restarts.identity();
    }

    /** Begins to poll the robot, and shows a warning if its running mode may move it. */
    public void watch() {
        watching = true;
        restarts.warnOfMode();
    }

    /** The latest proximity readings; null before the first. */
    public @Nullable Proximity proximity() {
        return polled.proximity();
    }

    public PolledAnswers polled() {
        return polled;
    }

    public PoseEstimator pose() {
        return pose;
    }

    MotionWatch motion() {
        return motion;
    }

    public MotorCheck wheels() {
        return wheels;
    }

    /** Does everything that is due. Called by the timer thread. */
    public void tick() {
        HemissonSession open = session;
        if (open == null || open.isClosed()) {
            return;
        }
        open.conversation().tick();
        if (!watching) {
            return;
        }
        endOverdueMotion(open.conversation());
        if (owner.isConnected()) {
            polling.tick(open.conversation(), identity());
            loss.noticeSilence(open);
        } else if (owner.isLost()) {
            loss.stopAfterLoss(open);
        }
    }

    private void endOverdueMotion(Conversation conversation) {
        if (conversation.mayMove() && motion.isOverdue(time.nanos())) {
            conversation.stop();
        }
    }

    @Override
    public void answered(Exchange exchange) {
        Reply reply = exchange.reply();
        try {
            if (reply != null) {
                answered(exchange, reply);
            }
        } finally {
            changes.raise();
        }
    }

    private void answered(Exchange exchange, Reply reply) {
        switch (exchange.purpose()) {
            case MOTION, STOP -> motorsAnswered(exchange);
            case VERIFY -> verified(exchange, reply);
            case ASK -> valueAnswered(exchange, reply);
        }
    }

    /** Follows the values sent, unless a running mode overrides them; then the reported speeds are followed. */
    private void motorsAnswered(Exchange exchange) {
        MotorValues values = exchange.question().motorValues();
        wheels.confirmed(values);
        if (identity().isRemoteControlled() || !identity().tellsSpeeds()) {
            pose.follow(values, exchange.middleNanos());
        }
    }

    private void valueAnswered(Exchange exchange, Reply reply) {
        Question question = exchange.question();
        if (!question.isLong() && reply.kind() == Reply.Kind.ANSWER) {
            polled.answered(question, reply, exchange.askedNanos());
            pose.answered(exchange.askedNanos());
        }
        HemissonSession open = session;
        if (question == Question.SWITCHES && open != null) {
            restarts.switchesRead(reply, open.conversation());
        }
        if (question == Question.SPEEDS) {
            checkSpeeds(exchange, reply);
        }
    }

    private void checkSpeeds(Exchange exchange, Reply reply) {
        HemissonSession open = session;
        String difference = wheels.compare(reply, identity());
        if (open != null
                && watching
                && difference != null
                && open.conversation().mayMove()) {
            open.conversation().stop();
            motion.meets(difference);
        }
        follow(exchange, reply);
    }

    private void verified(Exchange exchange, Reply reply) {
        restarts.speedsVerified(reply);
        String difference = wheels.compare(reply, identity());
        if (difference != null) {
            motion.meets(difference);
        }
        follow(exchange, reply);
    }

    private void follow(Exchange exchange, Reply speeds) {
        if (speeds.kind() == Reply.Kind.ANSWER && !MotorValues.of(speeds).equals(pose.wheels())) {
            pose.follow(MotorValues.of(speeds), exchange.middleNanos());
        }
    }

    @Override
    public void missed(Exchange exchange, boolean inMotion) {
        if (exchange.isRefused()) {
            polled.refused(exchange.question());
        }
        if (inMotion) {
            String failure = exchange.failure();
            if (motion.meets(failure == null ? "it missed an answer" : "it missed an answer: " + failure)) {
                owner.notice("it did not answer while moving; MAJIC repeats the stop; " + StopConfirmation.HELP);
            }
        }
        changes.raise();
    }

    /**
     * Handles a restart. During connecting the greeting may be an old one from a buffer; later the robot is asked for
     * its switches and its speeds.
     */
    @Override
    public void wasReset() {
        motion.meets("it was switched on or reset meanwhile");
        wheels.confirmed(MotorValues.STILL);
        pose.follow(MotorValues.STILL, time.nanos());
        owner.wasReset();
        HemissonSession open = session;
        if (open != null && watching) {
            restarts.restarted(open.conversation());
        }
    }

    @Override
    public void broken(IOException cause) {
        HemissonSession open = session;
        if (open != null && !open.isClosed()) {
            loss.broken(open, cause);
        }
    }
}
