package majic.team;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.function.Consumer;
import majic.bot.BotControl;
import majic.bot.BotException;
import majic.bot.MotionStopped;
import majic.bot.Unit;
import majic.driver.PermittedControl;
import majic.time.Signal;
import org.jspecify.annotations.Nullable;

/**
 * Manual control of one robot: drives it, or sets parameters that move it. {@link #drive} is called repeatedly while a
 * key is held, {@link #set} while a slider is dragged, from the event thread. Neither blocks; when calls come faster
 * than the robot follows, the newest value counts. No drive that comes after a stop of the robot is sent. When the
 * drives end, for any reason, the robot is stationary 600 ms later. Thread-safe.
 */
public final class ManualControl implements AutoCloseable {
    private static final Logger LOG = System.getLogger(ManualControl.class.getName());
    private static final String DRIVE = "";

    private final Member member;
    private final Owner owner;
    private final PermittedControl robot;
    private final Signal newSetting;
    private final ManualLog log;
    private final Map<String, Consumer<PermittedControl>> settings = new LinkedHashMap<>();
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
        this.owner = new Owner(Owner.Kind.MANUAL, "manual control", this::release);
        this.newSetting = member.bot().time().signal();
        this.log = new ManualLog(member.teamTime());
        member.check(true, null);
        if (!member.isIdle()) {
            throw new BotException(member.number() + " is busy; \"" + member.number() + " stop\" ends it");
        }
        this.robot = new PermittedControl(member.driver(), owner.permit()).forCommand();
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
        drive(mmPerSec, degPerSec, false);
    }

    /**
     * Sets the speed for the next 600 ms.
     *
     * @param mmPerSec forward positive
     * @param degPerSec counterclockwise positive
     * @param guarded whether the robot slows down and stops in front of obstacles, even if its parameter {@code guard}
     *     is off
     */
    public void drive(double mmPerSec, double degPerSec, boolean guarded) {
        put(DRIVE, robot -> {
            double share = robot.drive(mmPerSec, degPerSec, guarded);
            log.drove(share * mmPerSec, share * degPerSec);
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
        return put(parameter, robot -> {
            robot.set(parameter, number);
            log.set(parameter, number, isInMs(robot, parameter));
        });
    }

    /** Whether a script has to write the unit behind the number. */
    private static boolean isInMs(BotControl robot, String parameter) {
        return robot.parameters().stream()
                .anyMatch(known -> known.name().equalsIgnoreCase(parameter) && known.unit() == Unit.MS);
    }

    private boolean put(String what, Consumer<PermittedControl> setter) {
        synchronized (this) {
            if (released) {
                return false;
            }
            finishing = false;
            settings.put(what, setter);
        }
        newSetting.raise();
        return true;
    }

    /** Releases the robot as soon as all settings have been sent and have ended. Returns at once. */
    public void finish() {
        synchronized (this) {
            finishing = true;
        }
        newSetting.raise();
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
        owner.permit().revoke(() -> new MotionStopped("manual control has ended"));
        newSetting.raise();
    }

    /** Always ends by stopping the robot; the permit is revoked before, so that no drive follows that stop. */
    private void run() {
        @Nullable BotException problem = null;
        try {
            while (!released) {
                newSetting.await(this::hasWork, Signal.FOR_EVER);
                Consumer<PermittedControl> next = take();
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
            endDrive();
            if (problem != null && !(problem instanceof MotionStopped)) {
                member.report(problem);
            }
            member.free(owner);
            off = true;
            member.reportManual(log.end());
        }
    }

    private void endDrive() {
        try {
            member.bot().drive(0, 0);
        } catch (RuntimeException | Error e) {
            LOG.log(Level.DEBUG, "manual control could not stop robot " + member.number(), e);
        }
    }

    private synchronized boolean hasWork() {
        return released || finishing || !settings.isEmpty();
    }

    /** Returns the oldest pending setting; if there is none and none can follow, ends manual control. */
    private synchronized @Nullable Consumer<PermittedControl> take() {
        Iterator<Consumer<PermittedControl>> oldest = settings.values().iterator();
        if (!oldest.hasNext()) {
            released |= finishing;
            return null;
        }
        Consumer<PermittedControl> taken = oldest.next();
        oldest.remove();
        return taken;
    }
}
