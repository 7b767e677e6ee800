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
 * A person's hand on one robot: it drives, or sets what moves it. {@link #drive} is called again and again while a key is
 * held, {@link #set} while a slider is dragged, from the event thread: neither blocks, and of what comes faster than the
 * robot follows the newest counts. When the drives end, for whatever reason, the robot stands 600 ms later. Thread-safe.
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
     * Takes a robot into the hand.
     *
     * @param member which robot
     * @throws BotException if a script or act has it, it has orders in its queue, or STOP is latched
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
        if (!member.time().begin("robot " + member.number() + " by hand", this::run)) {
            member.free(owner);
            throw new BotException(member.number() + ": the system has no thread left to drive it by hand");
        }
    }

    /**
     * Drives on, for the next 600 ms.
     *
     * @param mmPerSec ahead positive
     * @param degPerSec counterclockwise positive
     */
    public void drive(double mmPerSec, double degPerSec) {
        wish(DRIVE, robot -> {
            robot.drive(mmPerSec, degPerSec);
            done.drove(mmPerSec, degPerSec);
        });
    }

    /**
     * Sets a parameter as soon as what was set before has ended; a value that was not yet sent is replaced. What goes
     * wrong is said to the person, and the robot is let go.
     *
     * @param parameter its name
     * @param number the value in its own unit
     * @return false if the hand is off the robot already, or about to be; nothing will be set then
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

    /** Lets the robot go as soon as all that was set has been done. Returns at once. */
    public void finish() {
        synchronized (this) {
            finishing = true;
        }
        wanted.raise();
    }

    /**
     * Whether the robot was let go.
     *
     * @return true once somebody else may have it
     */
    public boolean isOff() {
        return off;
    }

    /** Stands, and lets the robot go. Returns at once. */
    @Override
    public void close() {
        release();
    }

    private synchronized void release() {
        released = true;
        lease.revoke(() -> new MotionStopped("the hand is off"));
        wanted.raise();
    }

    /** Ends in a stand however it ends; the lease is gone before, so that nothing more is driven after a stop. */
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

    /** The oldest wish; when there is none and none is to come, the hand goes off. */
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
