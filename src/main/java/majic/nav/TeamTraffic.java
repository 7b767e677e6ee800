package majic.nav;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import majic.bot.MajicBot;
import majic.bot.Pose;
import majic.nav.path.FreeSpace;
import majic.nav.path.Way;
import org.jspecify.annotations.Nullable;

/**
 * The robots of one frame, and what each of them has reserved: where it stands, and the piece of its way on which it
 * may drive. A robot drives only on what it has reserved, and reserves nothing that another one has, so that no two of
 * them meet. Thread-safe.
 */
final class TeamTraffic {
    private static final double STEP_MM = 100;

    private final Map<MajicBot, Vehicle> vehicles = new LinkedHashMap<>();
    private long begun;

    /** One robot under way. All but the robot is guarded by the traffic. */
    static final class Vehicle {
        private final MajicBot robot;

        /** A lower number goes first: that of the motion that began earlier. */
        private final long order;

        /** The order of the robot for which it makes room; its own otherwise. */
        private long rank;

        private Way rest;
        private List<Pose> reserved;
        private @Nullable Long waitingNanos;
        private @Nullable Vehicle makesRoomFor;
        private @Nullable Wait wait;

        private Vehicle(MajicBot robot, long order) {
            this.robot = robot;
            this.order = order;
            this.rank = order;
            Pose here = robot.state().pose();
            this.rest = new Way(List.of(here));
            this.reserved = List.of(here);
        }

        MajicBot robot() {
            return robot;
        }
    }

    /** How much of its way a robot got, and which robot has the rest; null if it got all. */
    record Grant(double mm, @Nullable MajicBot before) {}

    /** A robot begins to drive by itself. */
    synchronized Vehicle begin(MajicBot robot) {
        begun++;
        Vehicle vehicle = new Vehicle(robot, begun);
        vehicles.put(robot, vehicle);
        return vehicle;
    }

    /** A robot stands, and keeps no way. */
    synchronized void end(Vehicle vehicle) {
        vehicles.remove(vehicle.robot, vehicle);
    }

    synchronized boolean isUnderWay(MajicBot robot) {
        return vehicles.containsKey(robot);
    }

    /** Returns the way that a robot still has; empty if it does not drive by itself. */
    synchronized Optional<Way> way(MajicBot robot) {
        return Optional.ofNullable(vehicles.get(robot)).map(vehicle -> vehicle.rest);
    }

    /** Returns the places that a robot has reserved; none if it does not drive by itself. */
    synchronized List<Pose> reserved(MajicBot robot) {
        Vehicle vehicle = vehicles.get(robot);
        return vehicle == null ? List.of() : vehicle.reserved;
    }

    /** Keeps why a robot stands; null while it drives. */
    synchronized void explain(Vehicle vehicle, @Nullable Wait wait) {
        vehicle.wait = wait;
    }

    /** Returns why a robot stands on its way; empty while it drives, and if it does not drive by itself. */
    synchronized Optional<Wait> waits(MajicBot robot) {
        return Optional.ofNullable(vehicles.get(robot)).map(vehicle -> vehicle.wait);
    }

    /**
     * Reserves as much of a way as is free, instead of what was reserved before.
     *
     * @param rest from where the robot is
     * @param mostMm how much of it
     */
    synchronized Grant reserve(Vehicle vehicle, Way rest, double mostMm) {
        vehicle.rest = rest;
        List<Pose> free = new ArrayList<>();
        free.add(vehicle.robot.state().pose());
        double end = Math.min(mostMm, rest.lengthMm());
        double granted = end;
        Vehicle other = null;
        for (double mm = 0; mm < end && other == null; mm += STEP_MM) {
            Pose next = rest.at(Math.min(end, mm + STEP_MM));
            other = holder(vehicle, next, free.get(0));
            if (other == null) {
                free.add(next);
            } else {
                granted = mm;
            }
        }
        vehicle.reserved = free;
        return new Grant(granted, other == null ? null : other.robot);
    }

    /** A robot that cannot drive on gives back what is reserved ahead of it, so that others can make room there. */
    synchronized void giveBack(Vehicle vehicle) {
        vehicle.reserved = List.of(vehicle.robot.state().pose());
    }

    /** Whether no other robot has reserved a place for itself, as seen from where a robot is. */
    synchronized boolean isFree(Vehicle vehicle, Pose place) {
        return holder(vehicle, place, vehicle.robot.state().pose()) == null;
    }

    /**
     * Notes whether a robot waits for another one.
     *
     * @return for how long it has waited, s
     */
    synchronized double noteWait(Vehicle vehicle, boolean now) {
        if (!now) {
            vehicle.waitingNanos = null;
        } else if (vehicle.waitingNanos == null) {
            vehicle.waitingNanos = vehicle.robot.time().nanos();
        }
        return waitedS(vehicle);
    }

    private static double waitedS(Vehicle vehicle) {
        Long since = vehicle.waitingNanos;
        return since == null ? 0 : vehicle.robot.time().secondsSince(since);
    }

    /** Whether several robots are under way. */
    synchronized boolean isBusy() {
        return vehicles.size() > 1;
    }

    /** The other one that has reserved a place, unless the robot gets farther from it by going there. */
    private @Nullable Vehicle holder(Vehicle vehicle, Pose place, Pose here) {
        for (Vehicle other : vehicles.values()) {
            double apart = apartMm(vehicle.robot, other.robot);
            if (other != vehicle
                    && other.reserved.stream()
                            .anyMatch(taken -> taken.distanceMm(place) < apart
                                    && taken.distanceMm(place) < taken.distanceMm(here) + 1)) {
                return other;
            }
        }
        return null;
    }

    static double apartMm(MajicBot robot, MajicBot other) {
        return robot.profile().bodyMm() + other.profile().bodyMm() + 2 * FreeSpace.MARGIN_MM;
    }

    /**
     * Returns the robot for which another one has to make room: one that goes first, waits, and has a way that leads
     * through where the other one is.
     *
     * @param lookMm how far along its way to look
     * @param waitS how long it has to have waited
     */
    synchronized Optional<Vehicle> toMakeRoomFor(Vehicle vehicle, double lookMm, double waitS) {
        return vehicles.values().stream()
                .filter(other -> other != vehicle && other.rank < vehicle.order && waitedS(other) >= waitS)
                .filter(other ->
                        leadsThrough(other, vehicle.robot, vehicle.robot.state().pose(), lookMm))
                .findFirst();
    }

    /** Whether the way of one that is under way leads through a place, for a robot there. */
    synchronized boolean leadsThrough(Vehicle vehicle, MajicBot robot, Pose place, double lookMm) {
        return leadsThrough(vehicle, place, lookMm, apartMm(vehicle.robot, robot));
    }

    /** Whether a robot at a place leaves room for one that is under way, also if that changes its way a little. */
    synchronized boolean isAside(Vehicle vehicle, MajicBot robot, Pose place, double lookMm) {
        return !leadsThrough(vehicle, place, lookMm, apartMm(vehicle.robot, robot) + STEP_MM);
    }

    private static boolean leadsThrough(Vehicle vehicle, Pose place, double lookMm, double apart) {
        double end = Math.min(lookMm, vehicle.rest.lengthMm());
        for (double mm = 0; mm <= end + STEP_MM; mm += STEP_MM) {
            if (vehicle.rest.at(mm).distanceMm(place) < apart) {
                return true;
            }
        }
        return false;
    }

    synchronized boolean isUnderWay(Vehicle vehicle) {
        return vehicles.get(vehicle.robot) == vehicle;
    }

    /**
     * A robot makes room for another one, and waits no longer for it; it goes before all others that have to, until
     * {@link #takeBack}.
     */
    synchronized void standIn(Vehicle vehicle, Vehicle one) {
        vehicle.rank = Math.min(vehicle.rank, one.rank);
        vehicle.makesRoomFor = one;
        vehicle.waitingNanos = null;
    }

    synchronized void takeBack(Vehicle vehicle) {
        vehicle.rank = vehicle.order;
        vehicle.makesRoomFor = null;
    }

    /** Whether another robot makes room for one, by the way that this one has now. */
    synchronized boolean isRoomMadeFor(Vehicle vehicle) {
        return vehicles.values().stream().anyMatch(other -> other.makesRoomFor == vehicle);
    }
}
