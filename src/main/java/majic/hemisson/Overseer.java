package majic.hemisson;

import java.io.IOException;
import java.util.List;
import majic.bot.LinkLost;
import majic.bot.Pose;
import majic.hemisson.Question.Purpose;
import org.jspecify.annotations.Nullable;

/**
 * Keeps an eye on the robot: asks what it sees all the while, more often while it moves, keeps the estimate of where it
 * is, notices missed answers, disobedience and silence. Called by the keeper and the reader; never waits.
 */
final class Overseer implements ConversationListener {
    private static final double SILENCE_S = 2;
    private static final int IDLE_TICKS_PER_LOOK = 2;

    private final MajicHemisson bot;
    private final MotionWatch motion;
    private final Senses senses = new Senses();
    private final Lookout lookout = new Lookout(senses);
    private volatile @Nullable Session session;
    private volatile @Nullable Exchange look;
    private volatile Track track;
    private volatile boolean watching;
    private volatile boolean modeUnknown;
    private long ticks;

    Overseer(MajicHemisson bot, Track track) {
        this.bot = bot;
        this.track = track;
        this.motion = new MotionWatch(bot.nanos());
    }

    /** Takes over a new connection. */
    void begin(Session opened) {
        watching = false;
        modeUnknown = false;
        look = null;
        senses.forget();
        motion.begins(Long.MAX_VALUE);
        session = opened;
        track = Track.standing(Pose.START, bot.nanos(), track.table());
    }

    /** Begins to ask the robot what it sees. */
    void watch() {
        watching = true;
    }

    void use(SpeedTable table) {
        long now = bot.nanos();
        track = new Track(track.at(now), now, track.wheels(), table);
    }

    /** What it saw last; null before the first reading. */
    @Nullable
    Proximity seen() {
        return senses.seen();
    }

    Senses senses() {
        return senses;
    }

    Track track() {
        return track;
    }

    MotionWatch motion() {
        return motion;
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
            noticeSilence(open);
        } else if (bot.isLost()) {
            standAfterLoss(open);
        }
    }

    @Override
    public void answered(Exchange exchange) {
        Reply reply = exchange.reply();
        if (exchange.purpose() == Purpose.MOTION) {
            follow(exchange.question().told(), exchange.middleNanos());
        } else if (exchange.purpose() == Purpose.STOP) {
            follow(Wheels.STILL, exchange.middleNanos());
        } else if (exchange.purpose() == Purpose.ASK && reply != null) {
            take(exchange, reply);
        }
        bot.raise();
    }

    private void take(Exchange exchange, Reply reply) {
        Question question = exchange.question();
        if (!question.isLong() && reply.kind() == Reply.Kind.ANSWER) {
            senses.take(question, reply, bot.nanos());
            bot.publishTrack(track);
        }
        if (question == Question.SWITCHES && modeUnknown) {
            modeUnknown = false;
            learnMode(reply.numbers());
        }
        if (exchange == look && question == Question.SPEEDS) {
            checkSpeeds(reply);
        }
    }

    @Override
    public void missed(Exchange exchange) {
        if (exchange.isRefused()) {
            senses.refuse(exchange.question());
        }
        Session open = session;
        if (open != null && open.conversation().mayMove()) {
            String failure = exchange.failure();
            if (motion.meets(failure == null ? "it missed an answer" : "it missed an answer: " + failure)) {
                bot.say("it did not answer while moving; it is told to stand again and again; " + MajicHemisson.HELP);
            }
        }
        bot.raise();
    }

    /** It reads its switches anew, and so may run in another mode from now on (sheet 4.3). */
    @Override
    public void wasReset() {
        motion.meets("it was switched on or reset meanwhile");
        modeUnknown = watching;
        follow(Wheels.STILL, bot.nanos());
        bot.lamps().forget();
        Session open = session;
        if (open != null && watching) {
            open.conversation().ask(Question.SWITCHES);
        }
        bot.say("it was switched on or reset; its motors stand and its lamps are off");
    }

    private void learnMode(List<Integer> switches) {
        Identity identity = bot.identity().restarted(switches);
        Session open = session;
        if (open != null) {
            open.conversation().brief(!identity.listens());
        }
        bot.recognise(identity);
    }

    @Override
    public void broken(IOException cause) {
        Session open = session;
        if (open != null && !open.isClosed()) {
            lose(open, "connection lost: " + cause.getMessage(), "nothing in MAJIC can stop it now: ");
            open.close();
        }
    }

    private void follow(Wheels wheels, long nanos) {
        track = track.then(wheels, nanos);
        bot.publishTrack(track);
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
            look = open.conversation()
                    .ask(lookout.next(bot.nanos(), moving, bot.identity().tellsSpeeds()));
        }
    }

    /** Other speeds than were set come from the TV remote or from another running mode (sheet 7 and 8). */
    private void checkSpeeds(Reply reply) {
        Wheels told = track.wheels();
        Session open = session;
        if (open == null || reply.numbers().equals(List.of(told.left(), told.right()))) {
            return;
        }
        open.conversation().stop();
        motion.meets("its wheels were set to " + reply.rest()
                + " by something else: a TV remote control, or a running mode "
                + "other than remote control (put all four switches to the side that reads 1 and restart it)");
    }

    private void noticeSilence(Session open) {
        double silence = open.conversation().silentSeconds();
        if (silence < Math.max(SILENCE_S, 4 * open.timeoutSeconds())) {
            return;
        }
        boolean moving = lose(
                open,
                "connection lost: no answer for " + Math.round(silence) + " s; the robot is off or has gone deaf: "
                        + "switch it off, wait 5 s, switch it on and connect again",
                "");
        if (!moving) {
            open.close();
        }
    }

    private boolean lose(Session open, String how, String moved) {
        boolean moving = open.conversation().mayMove();
        bot.lose(new LinkLost(moving ? how + "; " + moved + MajicHemisson.HELP : how));
        return moving;
    }

    /** A robot lost in motion is told to stand until it hears or the connection is given up. */
    private void standAfterLoss(Session open) {
        if (open.conversation().isStanding()) {
            bot.say("it answers again and stands; connect again to go on");
            open.close();
        } else {
            open.conversation().stop();
        }
    }
}
