package majic.hemisson;

import java.io.IOException;
import java.util.List;
import majic.bot.LinkLost;
import majic.bot.MotionFailed;
import majic.bot.Pose;
import majic.hemisson.Question.Purpose;
import org.jspecify.annotations.Nullable;

/**
 * Keeps an eye on the robot: asks what it sees all the while, more often while it moves, keeps the estimate of where it
 * is, notices missed answers, disobedience and silence. Called by the keeper and the reader; never waits.
 */
final class Overseer implements ConversationListener {
    /** A drive that nobody renews has lapsed before this; calls nearer to each other are one drive, ns. */
    private static final long LONGEST_DRIVE_NANOS = 700_000_000;

    /** How long after the planned end of a motion the robot is told to stand whatever the motion's thread does, ns. */
    private static final long OVERTIME_NANOS = 300_000_000;

    private static final double SILENCE_S = 2;
    private static final int IDLE_TICKS_PER_LOOK = 2;
    private static final int LOOKS_PER_SPEED_CHECK = 8;
    private static final double LINE_KEPT_FREE_S = 0.01;

    private final MajicHemisson bot;
    private volatile @Nullable Session session;
    private volatile @Nullable Exchange look;
    private volatile @Nullable String trouble;
    private volatile @Nullable Proximity seen;
    private volatile Track track;
    private volatile long motionDueNanos = Long.MAX_VALUE;
    private volatile long drivenNanos;
    private volatile boolean watching;
    private long ticks;
    private long looks;

    Overseer(MajicHemisson bot, Track track) {
        this.bot = bot;
        this.track = track;
        this.drivenNanos = bot.nanos() - LONGEST_DRIVE_NANOS;
    }

    /** Takes over a new connection. */
    void begin(Session opened) {
        watching = false;
        look = null;
        seen = null;
        trouble = null;
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
        return seen;
    }

    Track track() {
        return track;
    }

    /** What went wrong since the last motion began, as half a sentence; null if nothing did. */
    @Nullable
    String trouble() {
        return trouble;
    }

    /** Forgets earlier trouble, and sets when the motion that begins must be over at the latest. */
    void motionBegins(long dueNanos) {
        trouble = null;
        motionDueNanos = dueNanos;
    }

    /**
     * Notes that somebody drives, once more or anew.
     *
     * @throws MotionFailed if this drive has met with trouble; it does not resume until it was let go
     */
    void driveBeginsOrGoesOn() {
        long now = bot.nanos();
        String met = trouble;
        boolean goesOn = now - drivenNanos < LONGEST_DRIVE_NANOS;
        drivenNanos = now;
        if (goesOn && met != null) {
            throw new MotionFailed(met);
        }
        motionBegins(now + LONGEST_DRIVE_NANOS);
    }

    /** Sets when the motion under way is to end; the line is kept free for its stop shortly before. */
    void motionEnds(long dueNanos) {
        motionDueNanos = dueNanos;
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
        if (exchange.question() == Question.PROXIMITY && reply != null) {
            Proximity before = seen;
            seen = before == null ? new Proximity(reply.numbers()) : before.next(reply.numbers());
            bot.publishTrack(track);
        } else if (exchange.purpose() == Purpose.MOTION) {
            follow(exchange.question().told(), exchange.middleNanos());
        } else if (exchange.purpose() == Purpose.STOP) {
            follow(Wheels.STILL, exchange.middleNanos());
        } else if (exchange == look && reply != null) {
            checkSpeeds(reply);
        }
        bot.raise();
    }

    @Override
    public void missed(Exchange exchange) {
        Session open = session;
        if (open != null && open.conversation().mayMove() && trouble == null) {
            trouble = exchange.failure() == null ? "it missed an answer" : "it missed an answer: " + exchange.failure();
            bot.say("it did not answer while moving; it is told to stand again and again; " + MajicHemisson.HELP);
        }
        bot.raise();
    }

    @Override
    public void wasReset() {
        trouble = "it was switched on or reset meanwhile";
        follow(Wheels.STILL, bot.nanos());
        bot.lamps().forget();
        bot.say("it was switched on or reset; its motors stand and its lamps are off");
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
        if (conversation.mayMove() && bot.nanos() - motionDueNanos > OVERTIME_NANOS) {
            conversation.stop();
        }
    }

    /** Whether the stop of a timed motion is so near that nothing else may be asked. */
    boolean isStopNear() {
        Session open = session;
        return open != null && stopIsNear(open);
    }

    private void lookAround(Session open) {
        Exchange last = look;
        boolean moving = open.conversation().mayMove();
        boolean turn = moving || ticks % IDLE_TICKS_PER_LOOK == 0;
        if (!turn || (last != null && !last.isDone()) || (moving && stopIsNear(open))) {
            return;
        }
        looks++;
        boolean check = moving && bot.identity().tellsSpeeds() && looks % LOOKS_PER_SPEED_CHECK == 0;
        look = open.conversation().ask(check ? Question.SPEEDS : Question.PROXIMITY);
    }

    /** A question begun now could delay the stop of a timed motion. */
    private boolean stopIsNear(Session open) {
        double leftSeconds = (motionDueNanos - bot.nanos()) / 1e9;
        double roundTrip = open.conversation().quality().roundTripMs() / 1000;
        return leftSeconds >= 0 && leftSeconds < Math.min(2 * roundTrip, open.timeoutSeconds()) + LINE_KEPT_FREE_S;
    }

    /** Other speeds than were set come from the TV remote or from another running mode (sheet 7 and 8). */
    private void checkSpeeds(Reply reply) {
        Wheels told = track.wheels();
        Session open = session;
        if (open == null || reply.numbers().equals(List.of(told.left(), told.right()))) {
            return;
        }
        open.conversation().stop();
        trouble =
                "its wheels were set to " + reply.rest() + " by something else: a TV remote control, or a running mode "
                        + "other than remote control (put all four switches to the side that reads 1 and restart it)";
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
