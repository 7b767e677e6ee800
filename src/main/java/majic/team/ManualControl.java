package majic.team;

import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.function.Consumer;
import majic.bot.BotControl;
import majic.bot.BotException;
import majic.bot.MotionStopped;
import majic.bot.Permit;
import majic.bot.PermittedControl;
import majic.time.Signal;
import org.jspecify.annotations.Nullable;

/**
 * Manual control of one robot: drives it, or sets parameters that move it. {@link #drive} is called repeatedly while a
 * key is held, {@link #set} while a slider is dragged, from the event thread. Neither blocks; when calls come faster
 * than the robot follows, the newest value counts. When the drives end, for any reason, the robot is stationary 600 ms
 * later. Thread-safe.
 */
public final class ManualControl implements AutoCloseable {
    private static final String DRIVE = "";

    private final Member member;
    private final Owner owner;
    private final Permit lease = new Permit();
    private final Signal wanted;
    private final ManualLog done;
    private final Map<String, Consumer<BotControl>> wishes = new LinkedHashMap<>();
    private boolean finishing;
    private volatile boolean released;
    private volatile boolean off;

    /**
     * Takes manual control of a robot.
     *
     * @param member which robot
     * @throws BotException if a script or act owns it, it has commands in its queue, or STOP is latched
     */
    public ManualControl(Member member) {
        this.member = member;
        this.owner = new Owner(Owner.Kind.HAND, "the hand", this::release);
        this.wanted = member.bot().time().signal();
        this.done = new ManualLog(member.teamTime());
        member.check(true, null);
        if (!member.isIdle()) {
            throw new BotException(member.number() + " is busy; \"" + member.number() + " stop\" ends it");
        }
        member.claim(owner);
        if (!member.time().tryRunAsync("robot " + member.number() + " by hand", this::run)) {
            member.free(owner);
            throw new BotException(member.number() + ": the system has no thread left to drive it by hand");
        }
    }

    /**
     * Sets the speed for the next 600 ms.
     *
     * @param mmPerSec forward positive
     * @param degPerSec counterclockwise positive
     */
    public void drive(double mmPerSec, double degPerSec) {
        wish(DRIVE, robot -> {
            robot.drive(mmPerSec, degPerSec);
            done.drove(mmPerSec, degPerSec);
        });
    }

    /**
     * Sets a parameter as soon as the previous setting has ended; a value that was not yet sent is replaced. An error
     * is reported to the user and releases the robot.
     *
     * @param parameter its name
     * @param number the value in its own unit
     * @return false if the robot was released already, or is about to be; nothing will be set then
     */
    public boolean set(String parameter, double number) {
        return wish(parameter, robot -> {
            robot.set(parameter, number);
            done.set(parameter, number);
        });
    }

    private boolean wish(String what, Consumer<BotControl> how) {
        synchronized (this) {
            if (released) {
                return false;
            }
            finishing = false;
            wishes.put(what, how);
        }
        wanted.raise();
        return true;
    }

    /** Releases the robot as soon as all settings have been sent and have ended. Returns at once. */
    public void finish() {
        synchronized (this) {
            finishing = true;
        }
        wanted.raise();
    }

    /**
     * Returns whether the robot was released.
     *
     * @return true once the robot may have another owner
     */
    public boolean isOff() {
        return off;
    }

    /** Stops the robot and releases it. Returns at once. */
    @Override
    public void close() {
        release();
    }

    private synchronized void release() {
        released = true;
        lease.revoke(() -> new MotionStopped("the hand is off"));
        wanted.raise();
    }

    /** Always ends by stopping the robot; the permission is revoked before, so that no drive follows a stop. */
    private void run() {
        BotControl robot = PermittedControl.of(member.bot(), lease);
        @Nullable BotException problem = null;
        try {
            while (!released) {
                wanted.await(this::hasWork, Signal.FOR_EVER);
                Consumer<BotControl> next = take();
                if (next != null && !released) {
                    next.accept(robot);
                }
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        } catch (BotException e) {
            problem = e;
        } finally {
            release();
            stand(robot);
            if (problem != null && !(problem instanceof MotionStopped)) {
                member.complain(problem);
            }
            member.free(owner);
            off = true;
            member.tellByHand(done.end());
        }
    }

    private void stand(BotControl robot) {
        try {
            robot.drive(0, 0);
        } catch (RuntimeException | Error e) {
            Team.LOG.log(System.Logger.Level.DEBUG, "a hand could not let robot " + member.number() + " stand", e);
        }
    }

    private synchronized boolean hasWork() {
        return released || finishing || !wishes.isEmpty();
    }

    /** Returns the oldest pending setting; if there is none and none can follow, ends manual control. */
    private synchronized @Nullable Consumer<BotControl> take() {
        Iterator<Consumer<BotControl>> oldest = wishes.values().iterator();
        if (!oldest.hasNext()) {
            released |= finishing;
            return null;
        }
        Consumer<BotControl> taken = oldest.next();
        oldest.remove();
        return taken;
    }
}
