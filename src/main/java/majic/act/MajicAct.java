package majic.act;

import java.io.ObjectStreamField;
import java.io.Serializable;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.function.Function;
import majic.bot.BotControl;
import majic.bot.MotionStopped;
import majic.bot.Permit;
import majic.bot.TimeSource;
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

    /** The robot, from the start of {@link #behave()} to its end; null before and after. */
    protected transient volatile @Nullable BotControl bot;

    private transient volatile @Nullable Lease lease;
    private transient volatile @Nullable TimeSource time;
    private transient volatile @Nullable CountDownLatch joined;

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
     * Called when the act has ended, on its thread, for tidying up. There is no robot any more.
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
        TimeSource clock = time;
        try {
            if (clock != null) {
                clock.sleep(seconds);
            }
        } catch (InterruptedException e) {
            interrupt();
        }
        if (isInterrupted()) {
            throw new MotionStopped("the act was ended");
        }
    }

    /**
     * Gives the act its robot and starts it; returns as soon as it lives by the clock.
     *
     * @param loan gives the robot under a permit that the act can lose: {@code member::control}
     * @param clock what its pauses go by, the robot's own
     * @throws IllegalThreadStateException if it was started before
     */
    public final void start(Function<Permit, BotControl> loan, TimeSource clock) {
        if (getState() != State.NEW) {
            throw new IllegalThreadStateException("an act runs only once");
        }
        Lease given = new Lease(loan);
        lease = given;
        bot = given;
        time = clock;
        CountDownLatch begun = new CountDownLatch(1);
        joined = begun;
        setDaemon(true);
        setName("act " + getClass().getSimpleName());
        start();
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
     * Ends the act from outside: halts the robot, takes it away, then interrupts the thread. From the first moment on
     * nothing the act says reaches the robot. Blocks as long as the robot's stop does; may be called again, and from
     * any thread.
     */
    public final void end() {
        Lease given = lease;
        try {
            if (given != null) {
                given.revoke();
            }
        } finally {
            interrupt();
        }
    }

    /** Runs the behaviour; called by the thread's start and by nobody else. */
    @Override
    public final void run() {
        TimeSource clock = time;
        CountDownLatch begun = joined;
        if (clock == null || begun == null) {
            throw new IllegalStateException("an act is started with its robot");
        }
        TimeSource.Membership membership = clock.join();
        begun.countDown();
        boolean cutShort = true;
        try {
            cutShort = !behaveToTheEnd();
        } finally {
            bot = null;
            tidyUp(cutShort);
            membership.close();
        }
    }

    private boolean behaveToTheEnd() {
        Lease given = lease;
        try {
            behave();
            return given == null || !given.isRevoked();
        } catch (MotionStopped e) {
            LOG.log(Level.DEBUG, "{0} was stopped", getName());
            return false;
        } catch (RuntimeException e) {
            LOG.log(Level.WARNING, getName() + " failed", e);
            return false;
        } finally {
            if (given != null) {
                given.revoke();
            }
        }
    }

    private void tidyUp(boolean cutShort) {
        try {
            ended(cutShort);
        } catch (RuntimeException e) {
            LOG.log(Level.WARNING, getName() + " failed at its end", e);
        }
    }
}
