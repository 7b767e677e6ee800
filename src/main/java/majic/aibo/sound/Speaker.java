package majic.aibo.sound;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Supplier;
import majic.aibo.urbi.Tags;
import majic.aibo.urbi.UrbiConnection;
import majic.aibo.urbi.UrbiRefusal;
import majic.aibo.urbi.UrbiRequest;
import majic.aibo.urbi.UrbiValue;
import majic.bot.BotException;
import majic.bot.LinkLost;
import majic.driver.Motion;

/**
 * Plays one sound at a time, to its end. A sound is sent in pieces on the connection for sensors, each after the end of
 * the one before (URBI sheet 12), so at most one piece plays on after a stop, and no motion waits for it. Waits as a
 * motion does, so a stop ends it at once. Thread-safe.
 */
public final class Speaker {
    private static final Logger LOG = System.getLogger(Speaker.class.getName());
    private static final double ANSWER_S = 4;
    private static final double LOOK_AGAIN_S = 0.032;

    /** The dog plays a chime when a client connects. */
    private static final double OTHERS_S = 10;

    private static final double LATE_S = 5;
    private static final double LONGEST_OF_STICK_S = 120;

    private final Supplier<UrbiConnection> connection;
    private final Volume volume;
    private final Tags tags = new Tags();
    private final AtomicBoolean busy = new AtomicBoolean();

    public Speaker(Supplier<UrbiConnection> connection, Volume volume) {
        this.connection = connection;
        this.volume = volume;
    }

    /** Sends a sound over and waits for its end. */
    void play(SpeakerSound sound, Motion motion) {
        alone(() -> {
            UrbiConnection on = connection.get();
            awaitQuiet(on, motion, OTHERS_S);
            for (int from = 0; from < sound.length(); ) {
                int end = sound.endOfPiece(from);
                motion.check();
                on.upload("speaker.val", SpeakerSound.FORMAT, sound.bytes(from, end, volume.share()));
                motion.pause(SpeakerSound.seconds(from, end));
                awaitQuiet(on, motion, LATE_S);
                from = end;
            }
        });
    }

    /**
     * Has the dog play a file of its own and waits for the end.
     *
     * @param file its name on the stick, of letters, digits, {@code _ - .} only
     * @return false if the dog has none of that name
     */
    boolean playOfStick(String file, Motion motion) {
        return alone(() -> {
            UrbiConnection on = connection.get();
            awaitQuiet(on, motion, OTHERS_S);
            UrbiRequest ask = new UrbiRequest(tags.next(), UrbiRequest.Expects.END);
            on.send(ask, ask.tag() + "+end: speaker.play(\"" + file + "\"),");
            boolean played = isPlayed(on, ask, motion);
            if (played) {
                awaitQuiet(on, motion, LONGEST_OF_STICK_S);
            }
            return played;
        });
    }

    private void alone(Runnable playing) {
        alone(() -> {
            playing.run();
            return true;
        });
    }

    private boolean alone(Supplier<Boolean> playing) {
        if (!busy.compareAndSet(false, true)) {
            throw new BotException("another sound is being played; it plays one at a time");
        }
        try {
            return playing.get();
        } finally {
            busy.set(false);
        }
    }

    private static boolean isPlayed(UrbiConnection on, UrbiRequest ask, Motion motion) {
        try {
            await(ask, LONGEST_OF_STICK_S, motion);
        } finally {
            on.forget(ask);
            if (!ask.isDone()) {
                end(on, ask);
            }
        }
        if (ask.failure() != null) {
            throw new UrbiRefusal("the dog refuses: " + ask.failure());
        }
        return !(ask.value() instanceof UrbiValue.Num answer && answer.amount() == 0);
    }

    private static void end(UrbiConnection on, UrbiRequest ask) {
        try {
            on.send("stop " + ask.tag() + ",");
        } catch (LinkLost e) {
            LOG.log(Level.DEBUG, "no end of a sound over a broken connection", e);
        }
    }

    /** Waits until the speaker has nothing left to play; a dog that does not report it is taken to be done. */
    private void awaitQuiet(UrbiConnection on, Motion motion, double seconds) {
        double lastS = motion.seconds() + seconds;
        while (leftMs(on, motion) > 0) {
            if (motion.seconds() > lastS) {
                throw new BotException("the dog's speaker has not ended what it plays for " + (int) seconds
                        + " s more than it should take");
            }
            motion.pause(LOOK_AGAIN_S);
        }
    }

    private double leftMs(UrbiConnection on, Motion motion) {
        UrbiRequest ask = on.ask(tags, "speaker.remain");
        try {
            await(ask, ANSWER_S, motion);
        } finally {
            on.forget(ask);
        }
        String failure = ask.failure();
        if (failure != null && !failure.startsWith("Unknown identifier")) {
            throw new UrbiRefusal("the dog refuses: " + failure);
        }
        return ask.value() instanceof UrbiValue.Num left ? left.amount() : 0;
    }

    private static void await(UrbiRequest ask, double seconds, Motion motion) {
        if (!motion.await(ask::isDone, seconds)) {
            throw new UrbiRefusal("the dog did not answer within " + (int) seconds + " s");
        }
    }
}
