package majic.act;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import majic.bot.BotControl;
import majic.bot.BotException;
import majic.bot.MajicBot;
import majic.bot.MotionStopped;
import majic.bot.Permit;
import majic.time.Signal;
import majic.time.TimeSource;
import org.jspecify.annotations.Nullable;

/** The robots that an act commands, by role. They are taken back together, for good. Thread-safe. */
final class Cast {
    private static final Logger LOG = System.getLogger(Cast.class.getName());

    private final Permit lease = new Permit();
    private final AtomicBoolean takenBack = new AtomicBoolean();
    private final List<MajicBot> all;
    private final Map<String, List<BotControl>> leases = new LinkedHashMap<>();

    /**
     * Robots lent from now on.
     *
     * @param robots by role, at least one each; {@value Role#ME} is the first
     */
    Cast(Map<String, List<MajicBot>> robots) {
        this.all = robots.values().stream().flatMap(List::stream).toList();
        robots.forEach((role, its) -> leases.put(
                role,
                its.stream().map(robot -> (BotControl) new Lease(robot, lease)).toList()));
    }

    /** What the act's own robot goes by. */
    TimeSource clock() {
        return all.get(0).time();
    }

    /** The robots that have a role, as long as they are lent; at least one. */
    List<BotControl> robots(String role) {
        List<BotControl> its = leases.get(role);
        if (its == null) {
            throw new BotException(
                    "the act has no robot called " + role + " (it has " + String.join(", ", leases.keySet()) + ")");
        }
        return its;
    }

    /**
     * Takes the leave to move back; returns at once. The robots still do what they were told last.
     *
     * @return whether this was the first time, so that nobody has halted them since
     */
    boolean revoke() {
        lease.revoke(() -> new MotionStopped("the act has ended"));
        return takenBack.compareAndSet(false, true);
    }

    /** What all is done by that the act orders. A stop of one of the robots revokes it, and so does a link that is lost. */
    Permit lease() {
        return lease;
    }

    /** Why the leave to move was taken back; null as long as it was not. */
    @Nullable
    BotException revocation() {
        try {
            lease.check();
            return null;
        } catch (BotException e) {
            return e;
        }
    }

    /**
     * Halts all robots side by side, and blocks as long as the slowest link takes: also on a thread that is interrupted,
     * as acts often are, since whoever gets a robot next must not be halted in another's place.
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
        for (MajicBot robot : all.subList(1, all.size())) {
            robot.time().aside("halting the " + robot.type().label(), () -> {
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

    private static void halt(MajicBot robot) {
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
