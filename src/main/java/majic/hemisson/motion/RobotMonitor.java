package majic.hemisson.motion;

import java.io.IOException;
import java.util.List;
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
    private static final int IDLE_TICKS_PER_LOOK = 2;

    private final Owner owner;
    private final TimeSource time;
    private final Signal changes;
    private final MotionWatch motion;
    private final PolledAnswers senses = new PolledAnswers();
    private final PollSchedule lookout = new PollSchedule(senses);
    private final PoseEstimator reckoning;
    private final ConnectionLoss loss;
    private final MotorCheck wheels = new MotorCheck();
    private volatile Identity identity = Identity.NONE;
    private volatile @Nullable HemissonSession session;
    private volatile @Nullable Exchange look;
    private volatile boolean watching;
    private volatile boolean modeUnknown;
    private volatile boolean restarted;
    private long ticks;

    /** The driver. Called by the timer thread and the reader; must not block. */
    public interface Owner {
        /** Whether the robot is connected, so that it is polled. */
        boolean isConnected();

        /** Whether its connection was lost, so that it is stopped until it confirms. */
        boolean isLost();

        /** Takes where the robot should be now. */
        void publish(BotState state);

        /** The robot was switched on or reset: its LEDs are off and its pins are inputs. */
        void wasReset();

        /** Shows a message to the user. */
        void say(String message);

        /** Gives the connection up. */
        void lose(LinkLost cause);
    }

    /**
     * Monitors nothing yet.
     *
     * @param changes raised after each answer, for all threads that wait for one
     * @param table what the motor values mean
     */
    public RobotMonitor(Owner owner, TimeSource time, Signal changes, SpeedTable table) {
        this.owner = owner;
        this.time = time;
        this.changes = changes;
        this.reckoning = new PoseEstimator(time, table, owner::publish, () -> identity.mayMoveUnreported());
        this.loss = new ConnectionLoss(owner::lose, owner::say);
        this.motion = new MotionWatch(time.nanos());
    }

    /** Starts with a new connection, before its first question. */
    public void begin(HemissonSession opened) {
        watching = false;
        modeUnknown = false;
        restarted = false;
        look = null;
        senses.forget();
        motion.begins(Long.MAX_VALUE);
        session = opened;
        reckoning.begin();
    }

    /** Takes the robot that answered at connecting. */
    public void identified(Identity found) {
        identity = found;
    }

    /** The robot that answered last; {@link Identity#NONE} before the first. */
    public Identity identity() {
        return identity;
    }

    /** Begins to poll the robot, and shows a warning if its running mode may move it. */
    public void watch() {
        watching = true;
        warnOfMode();
    }

    private void warnOfMode() {
        String warning = identity.warning();
        if (warning != null) {
            owner.say(warning);
        }
    }

    /** The latest proximity readings; null before the first. */
    public @Nullable Proximity seen() {
        return senses.seen();
    }

    public PolledAnswers senses() {
        return senses;
    }

    public PoseEstimator reckoning() {
        return reckoning;
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
        ticks++;
        open.conversation().tick();
        if (!watching) {
            return;
        }
        endOverdueMotion(open.conversation());
        if (owner.isConnected()) {
            lookAround(open);
            loss.noticeSilence(open);
        } else if (owner.isLost()) {
            loss.standAfter(open);
        }
    }

    @Override
    public void answered(Exchange exchange) {
        Reply reply = exchange.reply();
        try {
            if (reply != null) {
                take(exchange, reply);
            }
        } finally {
            changes.raise();
        }
    }

    private void take(Exchange exchange, Reply reply) {
        switch (exchange.purpose()) {
            case MOTION, STOP -> wasTold(exchange);
            case VERIFY -> verified(exchange, reply);
            case ASK -> learn(exchange, reply);
        }
    }

    /** Follows the values sent, unless a running mode overrides them; then the reported speeds are followed. */
    private void wasTold(Exchange exchange) {
        wheels.told(exchange.question().told());
        if (identity.isRemoteControlled() || !identity.tellsSpeeds()) {
            reckoning.follow(exchange.question().told(), exchange.middleNanos());
        }
    }

    private void learn(Exchange exchange, Reply reply) {
        Question question = exchange.question();
        if (!question.isLong() && reply.kind() == Reply.Kind.ANSWER) {
            senses.take(question, reply, time.nanos());
            reckoning.publish();
        }
        if (question == Question.SWITCHES && modeUnknown) {
            modeUnknown = false;
            learnMode(reply.numbers());
        }
        if (question == Question.SPEEDS) {
            checkSpeeds(exchange, reply);
        }
    }

    private void checkSpeeds(Exchange exchange, Reply reply) {
        HemissonSession open = session;
        String difference = wheels.compare(reply, identity);
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
        if (restarted) {
            restarted = false;
            boolean moves =
                    reply.kind() == Reply.Kind.ANSWER && !MotorValues.of(reply).isStill();
            owner.say("it was switched on or reset; its lamps are off, its motors " + (moves ? "run" : "stand"));
        }
        String difference = wheels.compare(reply, identity);
        if (difference != null) {
            motion.meets(difference);
        }
        follow(exchange, reply);
    }

    private void follow(Exchange exchange, Reply speeds) {
        if (speeds.kind() == Reply.Kind.ANSWER
                && !MotorValues.of(speeds).equals(reckoning.track().wheels())) {
            reckoning.follow(MotorValues.of(speeds), exchange.middleNanos());
        }
    }

    @Override
    public void missed(Exchange exchange, boolean inMotion) {
        if (exchange.isRefused()) {
            senses.refuse(exchange.question());
        }
        if (inMotion) {
            String failure = exchange.failure();
            if (motion.meets(failure == null ? "it missed an answer" : "it missed an answer: " + failure)) {
                owner.say("it did not answer while moving; it is told to stand again and again; "
                        + StopConfirmation.HELP);
            }
        }
        changes.raise();
    }

    /**
     * Handles a restart. The robot reads its switches again, so it may run in another mode from now on (sheet 4.3).
     * During connecting the greeting may be an old one from a buffer; later the robot is asked for its speeds first.
     */
    @Override
    public void wasReset() {
        motion.meets("it was switched on or reset meanwhile");
        modeUnknown = watching;
        restarted = watching;
        wheels.told(MotorValues.STILL);
        reckoning.follow(MotorValues.STILL, time.nanos());
        owner.wasReset();
        HemissonSession open = session;
        if (open != null && watching) {
            open.conversation().ask(Question.SWITCHES);
        }
    }

    private void learnMode(List<Integer> switches) {
        identity = identity.restarted(switches);
        HemissonSession open = session;
        if (open != null) {
            open.conversation().brief(!identity.listens());
            open.conversation().setsItsOwnSpeeds(identity.setsItsOwnSpeeds());
        }
        warnOfMode();
    }

    @Override
    public void broken(IOException cause) {
        HemissonSession open = session;
        if (open != null && !open.isClosed()) {
            loss.broken(open, cause);
        }
    }

    private void endOverdueMotion(Conversation conversation) {
        if (conversation.mayMove() && motion.isOverdue(time.nanos())) {
            conversation.stop();
        }
    }

    private void lookAround(HemissonSession open) {
        Exchange last = look;
        boolean moving = open.conversation().mayMove();
        boolean turn = moving || ticks % IDLE_TICKS_PER_LOOK == 0;
        boolean stopIsNear =
                moving && motion.isEndNear(time.nanos(), open.conversation().quality());
        if (turn && (last == null || last.isDone()) && !stopIsNear) {
            look = open.conversation().ask(lookout.next(time.nanos(), moving, identity));
        }
    }
}
