package majic.hemisson;

import java.io.IOException;
import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * Keeps an eye on the robot: asks what it sees all the while, more often while it moves, and notices missed answers,
 * disobedience and silence. Called by the keeper and the reader; never waits.
 */
final class Overseer implements ConversationListener {
    private static final int IDLE_TICKS_PER_LOOK = 2;

    private final MajicHemisson bot;
    private final MotionWatch motion;
    private final Senses senses = new Senses();
    private final Lookout lookout = new Lookout(senses);
    private final DeadReckoning reckoning;
    private final LossOfLink loss;
    private final WheelCheck wheels = new WheelCheck();
    private volatile @Nullable Session session;
    private volatile @Nullable Exchange look;
    private volatile boolean watching;
    private volatile boolean modeUnknown;
    private volatile boolean restarted;
    private long ticks;

    Overseer(MajicHemisson bot, SpeedTable table) {
        this.bot = bot;
        this.reckoning = new DeadReckoning(bot, table);
        this.loss = new LossOfLink(bot);
        this.motion = new MotionWatch(bot.nanos());
    }

    /** Takes over a new connection. */
    void begin(Session opened) {
        watching = false;
        modeUnknown = false;
        restarted = false;
        look = null;
        senses.forget();
        motion.begins(Long.MAX_VALUE);
        session = opened;
        reckoning.begin();
    }

    /** Begins to ask the robot what it sees. */
    void watch() {
        watching = true;
    }

    /** What it saw last; null before the first reading. */
    @Nullable
    Proximity seen() {
        return senses.seen();
    }

    Senses senses() {
        return senses;
    }

    DeadReckoning reckoning() {
        return reckoning;
    }

    MotionWatch motion() {
        return motion;
    }

    WheelCheck wheels() {
        return wheels;
    }

    /** Looks after everything whose time has come. Called by the keeper. */
    void tick() {
        Session open = session;
        if (open == null || open.isClosed()) {
            return;
        }
        ticks++;
        open.conversation().tick();
        if (!watching) {
            return;
        }
        endOverdueMotion(open.conversation());
        if (bot.isConnected()) {
            lookAround(open);
            loss.noticeSilence(open);
        } else if (bot.isLost()) {
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
            bot.raise();
        }
    }

    private void take(Exchange exchange, Reply reply) {
        switch (exchange.purpose()) {
            case MOTION, STOP -> wasTold(exchange);
            case VERIFY -> verified(exchange, reply);
            case ASK -> learn(exchange, reply);
        }
    }

    /** A running mode of the robot's own sets the wheels whatever they are told; where they go then is asked for. */
    private void wasTold(Exchange exchange) {
        wheels.told(exchange.question().told());
        Identity identity = bot.identity();
        if (identity.isRemoteControlled() || !identity.tellsSpeeds()) {
            reckoning.follow(exchange.question().told(), exchange.middleNanos());
        }
    }

    private void learn(Exchange exchange, Reply reply) {
        Question question = exchange.question();
        if (!question.isLong() && reply.kind() == Reply.Kind.ANSWER) {
            senses.take(question, reply, bot.nanos());
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
        Session open = session;
        String difference = wheels.compare(reply, bot.identity());
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
                    reply.kind() == Reply.Kind.ANSWER && !Wheels.of(reply).isStill();
            bot.say("it was switched on or reset; its lamps are off, its motors " + (moves ? "run" : "stand"));
        }
        String difference = wheels.compare(reply, bot.identity());
        if (difference != null) {
            motion.meets(difference);
        }
        follow(exchange, reply);
    }

    private void follow(Exchange exchange, Reply speeds) {
        if (speeds.kind() == Reply.Kind.ANSWER
                && !Wheels.of(speeds).equals(reckoning.track().wheels())) {
            reckoning.follow(Wheels.of(speeds), exchange.middleNanos());
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
                bot.say("it did not answer while moving; it is told to stand again and again; " + MajicHemisson.HELP);
            }
        }
        bot.raise();
    }

    /**
     * It reads its switches anew, and so may run in another mode from now on (sheet 4.3). A greeting that was left in a
     * buffer says nothing of a robot that is just being connected to; in mid session its speeds are asked for first.
     */
    @Override
    public void wasReset() {
        motion.meets("it was switched on or reset meanwhile");
        modeUnknown = watching;
        restarted = watching;
        wheels.told(Wheels.STILL);
        reckoning.follow(Wheels.STILL, bot.nanos());
        bot.lamps().forget();
        bot.pins().forget();
        Session open = session;
        if (open != null && watching) {
            open.conversation().ask(Question.SWITCHES);
        }
    }

    private void learnMode(List<Integer> switches) {
        Identity identity = bot.identity().restarted(switches);
        Session open = session;
        if (open != null) {
            open.conversation().brief(!identity.listens());
            open.conversation().setsItsOwnSpeeds(identity.setsItsOwnSpeeds());
        }
        bot.recognise(identity);
    }

    @Override
    public void broken(IOException cause) {
        Session open = session;
        if (open != null && !open.isClosed()) {
            loss.broken(open, cause);
        }
    }

    private void endOverdueMotion(Conversation conversation) {
        if (conversation.mayMove() && motion.isOverdue(bot.nanos())) {
            conversation.stop();
        }
    }

    private void lookAround(Session open) {
        Exchange last = look;
        boolean moving = open.conversation().mayMove();
        boolean turn = moving || ticks % IDLE_TICKS_PER_LOOK == 0;
        boolean stopIsNear =
                moving && motion.isEndNear(bot.nanos(), open.conversation().quality());
        if (turn && (last == null || last.isDone()) && !stopIsNear) {
            look = open.conversation().ask(lookout.next(bot.nanos(), moving, bot.identity()));
        }
    }
}
