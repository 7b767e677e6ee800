package majic.act;

import java.io.ObjectStreamField;
import java.io.Serializable;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CountDownLatch;
import majic.bot.BotControl;
import majic.bot.BotException;
import majic.bot.MajicBot;
import majic.bot.MotionStopped;
import majic.time.TimeSource;
import org.jspecify.annotations.Nullable;

/**
 * A behaviour: what a robot does by itself. An author extends it and writes {@link #behave()}, in which {@link #bot}
 * is the robot; everything kept in fields that are not transient is saved with the act.
 *
 * <p>An act runs once, on its own thread. It ends when {@link #behave()} returns or throws, or when somebody calls
 * {@link #end()}: then the robot is told to stand, every further use of {@link #bot} throws {@link MotionStopped}, and
 * the thread is interrupted, in that order. However it ends, {@link #ended(boolean)} is called, without a robot.
 */
public abstract class MajicAct extends Thread implements Serializable {
    private static final long serialVersionUID = 1;
    private static final Logger LOG = System.getLogger(MajicAct.class.getName());

    /** Nothing of this class is saved: a saved act has no thread, no robot and no clock, and is as new when read. */
    private static final ObjectStreamField[] serialPersistentFields = {};

    /**
     * The robot; null before the act is started. Once {@link #behave()} has ended, or the act was ended, every use of it
     * throws {@link MotionStopped}, on whatever thread.
     */
    protected transient volatile @Nullable BotControl bot;

    private transient volatile @Nullable Cast cast;
    private transient volatile @Nullable Audience audience;
    private transient volatile @Nullable Throwable failure;
    private transient volatile @Nullable Throwable endingFailure;
    private transient volatile @Nullable CountDownLatch joined;
    private transient volatile boolean calledOff;
    private transient volatile boolean hasBehaved;

    /** A behaviour that has no robot yet. Reading a saved act does not come by here. */
    protected MajicAct() {
        super("act");
    }

    /**
     * Which robots the act asks for, the first being the one it is loaded onto. Written into the act's file when that is
     * made, and asked again before the act starts; called without a robot, on any thread.
     *
     * @return at least one role; unless overridden, any one robot
     */
    public List<Role> roles() {
        return List.of(Role.any(Role.ME));
    }

    /**
     * What the robot does. Called once, on the thread of the act. It may simply return, use {@link #pause} between
     * motions, and let every exception pass.
     */
    protected abstract void behave();

    /**
     * Called when the act has ended, on its thread, for tidying up. Its robots obey it no more.
     *
     * @param cutShort true if the act was ended from outside or failed, false if {@link #behave()} came to its end
     */
    protected void ended(boolean cutShort) {}

    /**
     * Waits, on the clock of the robot. Unlike {@link Thread#sleep(long)}, which counts milliseconds, and which no
     * simulated lab knows of.
     *
     * @param seconds how long; zero or less returns at once
     * @throws MotionStopped if the act was ended meanwhile
     */
    protected final void pause(double seconds) {
        checkMayGoOn();
        Cast robots = cast;
        try {
            if (robots != null) {
                robots.clock().sleep(seconds);
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
        checkMayGoOn();
    }

    /** Only {@link #ended(boolean)} goes on without a robot. */
    private void checkMayGoOn() {
        Thread current = Thread.currentThread();
        Cast robots = cast;
        boolean tidying = hasBehaved && current == this;
        if (current.isInterrupted() || (!tidying && robots != null && robots.revocation() != null)) {
            throw new MotionStopped("the act was ended");
        }
    }

    /**
     * A further robot, by the role that {@link #roles()} gave it.
     *
     * @param role the act's word for it
     * @return the robot; of no use any more once the act has ended
     * @throws BotException if the act has no such role, or no robots yet
     */
    protected final BotControl robot(String role) {
        return robots(role).get(0);
    }

    /**
     * All robots of a role that {@link Role#orMore() may be several}.
     *
     * @param role the act's word for it
     * @return at least one, in the order they were named; of no use any more once the act has ended
     * @throws BotException if the act has no such role, or no robots yet
     */
    protected final List<BotControl> robots(String role) {
        Cast robots = cast;
        if (robots == null) {
            throw new BotException("an act has no robots before it is started");
        }
        return robots.robots(role);
    }

    /**
     * Tells the person what the act is doing: it stands beside the robot, among the messages and in the session log.
     *
     * @param words a few of them
     */
    protected final void say(String words) {
        Audience listening = audience;
        if (listening != null) {
            listening.said(words);
        }
    }

    /**
     * Gives the act its robot and starts it, outside of any session; returns as soon as it lives by the robot's clock.
     * What it says goes to the log.
     *
     * @param robot connected; nobody else should command it meanwhile
     * @throws IllegalThreadStateException if it was started before
     * @throws BotException if it needs another robot, or several, or the system has no thread for it
     */
    public final void start(MajicBot robot) {
        List<Role> wanted = roles();
        if (wanted.size() > 1) {
            throw new BotException("the act needs " + wanted.size() + " robots: " + wanted);
        }
        wanted.get(0).unfit(robot).ifPresent(why -> {
            throw new BotException("the robot " + why);
        });
        start(new Cast(Map.of(Role.ME, List.of(robot))), new Audience() {
            @Override
            public void said(String words) {
                LOG.log(Level.INFO, "{0}: {1}", getName(), words);
            }

            @Override
            public void ended() {
                warn(failure, " failed");
                warn(endingFailure, " failed in its ended()");
            }
        });
    }

    private void warn(@Nullable Throwable reason, String how) {
        if (reason != null && !(reason instanceof MotionStopped)) {
            LOG.log(Level.WARNING, getName() + how, reason);
        }
    }

    /** Starts the act with all its robots; returns as soon as it lives by the clock of its own. */
    final void start(Cast robots, Audience listening) {
        if (getState() != State.NEW) {
            throw new IllegalThreadStateException("an act runs only once");
        }
        CountDownLatch begun = new CountDownLatch(1);
        joined = begun;
        cast = robots;
        audience = listening;
        bot = robots.robots(Role.ME).get(0);
        if (calledOff) {
            robots.revoke();
        }
        setDaemon(true);
        setName("act " + getClass().getSimpleName());
        setContextClassLoader(getClass().getClassLoader());
        try {
            super.start();
        } catch (OutOfMemoryError e) {
            throw new BotException("the system has no thread left for the act; end another program and try again", e);
        }
        awaitQuietly(begun);
    }

    private static void awaitQuietly(CountDownLatch begun) {
        try {
            begun.await();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    /**
     * Ends the act from outside: takes its robots away, halts them, then interrupts the thread. From the first moment on
     * nothing the act says reaches a robot. Blocks as long as the slowest robot's stop does; may be called again, and
     * from any thread. An act that was ended before it is started does nothing when it is.
     */
    public final void end() {
        calledOff = true;
        Cast robots = cast;
        if (robots != null) {
            robots.revoke();
            robots.halt();
        }
        interrupt();
    }

    /** Why it failed or was cut short; null if it came to its end, or is still on its way. */
    final @Nullable Throwable failure() {
        return failure;
    }

    /** What {@link #ended(boolean)} failed by; null if it did not, or was not called yet. */
    final @Nullable Throwable endingFailure() {
        return endingFailure;
    }

    /**
     * An act is started with its robot, by {@link #start(MajicBot)} or by a session.
     *
     * @throws IllegalStateException always
     */
    @Override
    public final void start() {
        throw new IllegalStateException("an act is started with its robot");
    }

    /** Runs the behaviour; called by the thread's start and by nobody else. */
    @Override
    public final void run() {
        Cast robots = cast;
        Audience listening = audience;
        CountDownLatch begun = joined;
        if (robots == null || listening == null || begun == null) {
            throw new IllegalStateException("an act is started with its robot");
        }
        TimeSource.Membership membership = () -> {};
        try {
            membership = join(robots.clock(), begun);
            boolean cutShort = !behaveToTheEnd(robots);
            hasBehaved = true;
            tidyUp(cutShort);
        } catch (Throwable e) {
            failure = e;
        } finally {
            try {
                listening.ended();
            } finally {
                membership.close();
            }
        }
    }

    private static TimeSource.Membership join(TimeSource clock, CountDownLatch begun) {
        try {
            return clock.join();
        } finally {
            begun.countDown();
        }
    }

    /** Whatever the author's code throws, also what its methods do not declare, the robots are taken back and halted. */
    private boolean behaveToTheEnd(Cast robots) {
        try {
            if (robots.revocation() == null) {
                behave();
            }
            failure = robots.revocation();
        } catch (Throwable e) {
            BotException taken = robots.revocation();
            failure = taken == null ? e : taken;
        } finally {
            if (robots.revoke()) {
                robots.halt();
            }
        }
        return failure == null;
    }

    private void tidyUp(boolean cutShort) {
        try {
            ended(cutShort);
        } catch (Throwable e) {
            endingFailure = e;
        }
    }
}
