package majic.driver;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.Optional;
import java.util.function.Supplier;
import majic.bot.DriveGuard;
import majic.bot.DriveGuard.Room;
import majic.bot.MajicBot;
import majic.bot.Pose;
import majic.time.WaitPolicy;
import org.jspecify.annotations.Nullable;

/**
 * Decides how fast one robot may go, and which of its motions have to end, by what its {@link DriveGuard} finds. Asks
 * it without any lock: whatever becomes of it, a stop is sent. Thread-safe.
 */
final class GuardedDriving {
    private static final Logger LOG = System.getLogger(GuardedDriving.class.getName());

    /** Creeping more slowly is not worth it, mm/s. */
    private static final double SLOW_MM_PER_SEC = 25;

    private final MajicBot bot;
    private volatile @Nullable DriveGuard guard;
    private volatile Room last = Room.FREE;

    GuardedDriving(MajicBot bot) {
        this.bot = bot;
    }

    void use(@Nullable DriveGuard newGuard) {
        guard = newGuard;
    }

    boolean isPossible() {
        DriveGuard present = guard;
        return present != null && present.isPossible();
    }

    /** Returns the room for some speeds: none if the guard fails, all if there is nothing to go by. */
    private Room room(double mmPerSec, double degPerSec) {
        DriveGuard present = guard;
        Room[] found = {Room.FREE};
        if (present != null) {
            WaitPolicy.without(() -> found[0] = asked(present, mmPerSec, degPerSec));
        }
        return found[0];
    }

    private Room asked(DriveGuard present, double mmPerSec, double degPerSec) {
        try {
            return present.isPossible() ? present.room(mmPerSec, degPerSec) : Room.FREE;
        } catch (RuntimeException | LinkageError e) {
            LOG.log(Level.WARNING, "the guard of " + bot.name() + " failed", e);
            return new Room(0, "its guard failed; the log has the error");
        }
    }

    /** Returns whether a first reading is still to come. */
    boolean isWaiting() {
        return room(0, 0).equals(Room.WAITING);
    }

    /** Returns the share of some speeds that is allowed now, 0 to 1. */
    double share(double mmPerSec, double degPerSec) {
        Room room = room(mmPerSec, degPerSec);
        double share = share(Math.abs(mmPerSec), room);
        last = share < 1 ? room : Room.FREE;
        return share;
    }

    private double share(double asked, Room room) {
        if (asked == 0) {
            return room.mm() <= 0 ? 0 : 1;
        }
        double allowed = room.speedMmPerSec();
        double slowest = Math.max(SLOW_MM_PER_SEC, bot.profile().slowestMmPerSec());
        return allowed < Math.min(asked, slowest) ? 0 : Math.min(1, allowed / asked);
    }

    /** Returns why less than the speeds that were asked for last is allowed; empty if it is not. */
    Optional<String> reason() {
        return Optional.of(last.reason()).filter(reason -> !reason.isEmpty());
    }

    /** Returns what is in the way of a robot that stands, seen in a direction; empty if nothing is. */
    String obstacle(double mm) {
        return room(Math.copySign(SLOW_MM_PER_SEC, mm), 0).reason();
    }

    /** Returns what gives the reason to end a {@code move}, null while there is none. */
    Supplier<@Nullable String> endOfMove(double mm) {
        Pose start = odometry();
        return () -> {
            double speed = Math.max(SLOW_MM_PER_SEC, speed());
            double left = Math.abs(mm) - Math.abs(start.aheadMm(odometry()));
            Room room = room(Math.copySign(speed, mm), 0);
            return room.mm() < Math.min(left, Room.brakingMm(speed)) ? room.reason() : null;
        };
    }

    /** Returns what gives the reason to end a turn or a drive, null while there is none. */
    Supplier<@Nullable String> endOfDrive(double mmPerSec, double degPerSec) {
        return () -> share(mmPerSec, degPerSec) > 0 ? null : last.reason();
    }

    private double speed() {
        return bot.profile().estimates()
                ? bot.get("cruise").number()
                : Math.abs(bot.state().speedMmPerSec());
    }

    /** Returns the pose by odometry: a robot that is placed anew while it moves has not moved by that. */
    Pose odometry() {
        return bot.state().pose().seenFrom(bot.odometryOrigin());
    }
}
