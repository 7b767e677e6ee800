package majic.act;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import majic.bot.BotControl;
import majic.bot.BotException;
import majic.bot.MajicBot;
import majic.bot.MotionStopped;
import majic.driver.BotDriver;
import majic.driver.Permit;
import majic.driver.PermittedControl;
import majic.time.Signal;
import majic.time.TimeSource;
import org.jspecify.annotations.Nullable;

/** Holds the robots that an act commands, by role. All of them are released together, permanently. Thread-safe. */
final class ActRobots {
    private static final Logger LOG = System.getLogger(ActRobots.class.getName());

    private final Permit permit = new Permit();
    private final AtomicBoolean takenBack = new AtomicBoolean();
    private final List<BotDriver> all;
    private final Map<String, List<BotControl>> robotsByRole = new LinkedHashMap<>();
    private final Map<BotControl, MajicBot> controlled = new IdentityHashMap<>();

    /**
     * Creates a set of robots that the act may use from now on.
     *
     * @param robots by role, at least one each; {@value Role#ME} is the first
     */
    ActRobots(Map<String, List<MajicBot>> robots) {
        this.all = robots.values().stream()
                .flatMap(List::stream)
                .map(BotDriver::of)
                .toList();
        robots.forEach((role, its) ->
                robotsByRole.put(role, its.stream().map(this::control).toList()));
    }

    private BotControl control(MajicBot robot) {
        BotControl control = new PermittedControl(BotDriver.of(robot), permit);
        controlled.put(control, robot);
        return control;
    }

    /** Returns the robot that one of {@link #robots} commands. */
    MajicBot robot(BotControl control) {
        MajicBot robot = controlled.get(control);
        if (robot == null) {
            throw new BotException("the act has no robot " + control.name());
        }
        return robot;
    }

    /** Returns the clock of the act's own robot. */
    TimeSource clock() {
        return all.get(0).time();
    }

    /** Returns the robots of a role while the act may use them; at least one. */
    List<BotControl> robots(String role) {
        List<BotControl> its = robotsByRole.get(role);
        if (its == null) {
            throw new BotException("the act has no robot called " + role + " (it has "
                    + String.join(", ", robotsByRole.keySet()) + ")");
        }
        return its;
    }

    /**
     * Revokes the permission to move; returns at once. The robots still carry out the last commands sent to them.
     *
     * @return true if it was not revoked before, so the robots are not yet halted
     */
    boolean revoke() {
        permit.revoke(() -> new MotionStopped("the act has ended"));
        return takenBack.compareAndSet(false, true);
    }

    /**
     * Returns the permission under which all commands of the act run. A stop or a lost connection of one of the robots
     * revokes it.
     */
    Permit permit() {
        return permit;
    }

    /** Returns why the permission to move was revoked; null while it is valid. */
    @Nullable
    BotException revocation() {
        try {
            permit.check();
            return null;
        } catch (BotException e) {
            return e;
        }
    }

    /**
     * Halts all robots in parallel and blocks until the slowest connection has finished. Blocks on an interrupted
     * thread too (the threads of acts often are), so that no late stop reaches a robot that already has a new owner.
     */
    void halt() {
        boolean interrupted = Thread.interrupted();
        haltAll();
        if (interrupted) {
            Thread.currentThread().interrupt();
        }
    }

    private void haltAll() {
        AtomicInteger moving = new AtomicInteger(all.size() - 1);
        Signal halted = clock().signal();
        for (BotDriver robot : all.subList(1, all.size())) {
            robot.time().runAsync("halting the " + robot.type().label(), () -> {
                halt(robot);
                moving.decrementAndGet();
                halted.raise();
            });
        }
        halt(all.get(0));
        try {
            halted.await(() -> moving.get() == 0, Signal.FOR_EVER);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private static void halt(BotDriver robot) {
        try {
            robot.sendStop();
        } catch (BotException e) {
            LOG.log(
                    Level.DEBUG,
                    "the {0} could not be halted: {1}",
                    robot.type().label(),
                    e.getMessage());
        } catch (RuntimeException | Error e) {
            LOG.log(Level.ERROR, "the " + robot.type().label() + " could not be halted", e);
        }
    }
}
