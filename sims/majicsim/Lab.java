package majicsim;

import java.io.IOException;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import majicsim.aibo.AiboHandling;
import majicsim.aibo.AiboRobot;
import majicsim.hemisson.HemissonHandling;
import majicsim.hemisson.HemissonRobot;
import majicsim.net.Faults;
import majicsim.net.LineCount;
import majicsim.net.Port;
import majicsim.pioneer.PioneerHandling;
import majicsim.pioneer.PioneerRobot;
import majicsim.world.Point;
import majicsim.world.Pose;
import majicsim.world.Room;
import majicsim.world.Segment;
import majicsim.world.World;
import org.jspecify.annotations.Nullable;

/**
 * The simulated lab: one room, its robots, and their ports on loopback. Clients are answered as soon as it is open; its clock
 * stands until {@link #step()} or {@link #run} moves it. All methods may be called from any thread.
 */
public final class Lab implements AutoCloseable {
    /** Lab time of one step. */
    public static final long STEP_NANOS = 4_000_000;

    private static final double STEP_SECONDS = STEP_NANOS / 1e9;

    private final ReentrantLock lock;
    private final World world;
    private final List<Station> stations;
    private volatile long nanos;
    private @Nullable Pacer pacer;

    private Lab(ReentrantLock lock, World world, List<Station> stations) {
        this.lock = lock;
        this.world = world;
        this.stations = stations;
    }

    /**
     * Puts the robots into the room and opens their ports.
     *
     * @param options room, noise and ports
     * @return the open lab, its clock standing at 0
     * @throws IOException if a requested port is taken or the room has no place for a robot; the message names it, and nothing
     *     stays open
     */
    public static Lab open(LabOptions options) throws IOException {
        World world = new World(options.room());
        ReentrantLock lock = new ReentrantLock(true);
        return new Lab(lock, world, new Furnisher(options, world, lock).furnish());
    }

    /** One step: the world, then each robot's firmware and what is due on its lines. */
    public void step() {
        lock.lock();
        try {
            world.step(STEP_SECONDS);
            nanos += STEP_NANOS;
            stations.forEach(station -> station.step(STEP_SECONDS, nanos));
        } finally {
            lock.unlock();
        }
    }

    /**
     * Lab time since it was opened.
     *
     * @return ns, a multiple of {@link #STEP_NANOS}
     */
    public long nanos() {
        return nanos;
    }

    /**
     * Lets the lab's clock run on a daemon thread until it is closed; called again, at the new speed.
     *
     * @param speed lab seconds in a real second, above 0; what the machine cannot keep up with gets slower
     * @throws IllegalArgumentException if the speed is not above 0 and finite; the clock goes on as before
     */
    public synchronized void run(double speed) {
        if (!(speed > 0) || Double.isInfinite(speed)) {
            throw new IllegalArgumentException("the lab's speed must be above 0, not " + speed);
        }
        endPacer();
        pacer = new Pacer(this, speed);
        pacer.start();
    }

    /**
     * How to reach the robots: "aibo", "pioneer" and "hemisson" as "127.0.0.1:port", and "pioneer-pty" and "hemisson-pty" as
     * the paths of pseudo-terminals where the system has them.
     *
     * @return addresses by name, in the order of the robots' numbers
     */
    public Map<String, String> addresses() {
        Map<String, String> addresses = new LinkedHashMap<>();
        for (Station station : stations) {
            String suffix = "";
            for (Port port : station.ports()) {
                addresses.put(station.name() + suffix, port.address());
                suffix = "-pty";
            }
        }
        return addresses;
    }

    /**
     * Where the robots truly are.
     *
     * @return poses by robot, in the order of their numbers
     */
    public Map<String, Pose> truePoses() {
        return ofEach(station -> station.body().pose());
    }

    /**
     * How often each robot drove into something; being driven into does not count.
     *
     * @return since the lab was opened
     */
    public Map<String, Integer> bumps() {
        return ofEach(station -> station.body().bumps());
    }

    /**
     * The robots' outlines as they stand, for a drawing.
     *
     * @return corners in room coordinates by robot
     */
    public Map<String, List<Point>> outlines() {
        return ofEach(station -> station.body().outline());
    }

    /**
     * The room, for a drawing.
     *
     * @return its walls, unchangeable
     */
    public List<Segment> walls() {
        return world.room().walls();
    }

    /**
     * The room with all that stays where it is.
     *
     * @return the same at every call
     */
    public Room room() {
        return world.room();
    }

    /**
     * Lifts a robot and puts it down elsewhere.
     *
     * @param robot its name
     * @param p where to
     * @throws IllegalArgumentException if there is no such robot or it does not fit there; it stays where it was
     */
    public void place(String robot, Pose p) {
        Station station = station(robot);
        locked(() -> {
            station.body().place(p);
            return p;
        });
    }

    /**
     * The faults of a robot's lines.
     *
     * @param robot its name
     * @return its faults, to be ordered
     * @throws IllegalArgumentException if there is no such robot
     */
    public Faults faults(String robot) {
        return station(robot).wiring().faults();
    }

    /**
     * Acts on the Pioneer itself: presses its buttons, plugs its charger, reads its buzzer. The lab does not step meanwhile.
     *
     * @param action what to do; must not wait for anything
     */
    public void besidePioneer(Consumer<PioneerHandling> action) {
        beside(PioneerRobot.class, pioneer -> action.accept(pioneer.handling()));
    }

    /**
     * Acts on the Aibo itself: touches it, turns it over, reads what it played. The lab does not step
     * meanwhile.
     *
     * @param action what to do; must not wait for anything
     */
    public void besideAibo(Consumer<AiboHandling> action) {
        beside(AiboRobot.class, aibo -> action.accept(aibo.handling()));
    }

    /**
     * Acts on the Hemisson itself: presses keys of a TV remote, moves its switches, lifts it, switches it off and on. The
     * lab does not step meanwhile.
     *
     * @param action what to do; must not wait for anything
     */
    public void besideHemisson(Consumer<HemissonHandling> action) {
        beside(HemissonRobot.class, hemisson -> action.accept(hemisson.handling()));
    }

    /**
     * How far every line has got. Cheap and without a lock, for a clock that steps when nothing is in flight.
     *
     * @return one entry a line
     */
    public List<LineCount> lines() {
        return stations.stream()
                .flatMap(station -> station.ports().stream())
                .flatMap(port -> port.lines().stream())
                .toList();
    }

    /** Stops the clock and closes all ports and lines. */
    @Override
    public synchronized void close() {
        endPacer();
        stations.forEach(Station::close);
    }

    private void endPacer() {
        if (pacer != null) {
            pacer.end();
            pacer = null;
        }
    }

    private Station station(String robot) {
        return stations.stream()
                .filter(station -> station.name().equals(robot))
                .findFirst()
                .orElseThrow(
                        () -> new IllegalArgumentException("the lab has no robot " + robot + "; it has " + names()));
    }

    private String names() {
        return stations.stream().map(Station::name).collect(Collectors.joining(", "));
    }

    private <T> Map<String, T> ofEach(Function<Station, T> what) {
        return locked(() -> {
            Map<String, T> all = new LinkedHashMap<>();
            stations.forEach(station -> all.put(station.name(), what.apply(station)));
            return all;
        });
    }

    private <R> void beside(Class<R> robot, Consumer<R> action) {
        locked(() -> {
            stations.stream()
                    .map(station -> station.wiring().firmware())
                    .filter(robot::isInstance)
                    .map(robot::cast)
                    .forEach(action);
            return action;
        });
    }

    private <T> T locked(Supplier<T> work) {
        lock.lock();
        try {
            return work.get();
        } finally {
            lock.unlock();
        }
    }
}
