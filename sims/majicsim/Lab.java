package majicsim;

import java.io.IOException;
import java.util.ArrayList;
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
import majicsim.mavlink.MavlinkHandling;
import majicsim.mavlink.MavlinkVehicle;
import majicsim.net.Faults;
import majicsim.net.LabTime;
import majicsim.net.LineCount;
import majicsim.net.Port;
import majicsim.pioneer.PioneerHandling;
import majicsim.pioneer.PioneerRobot;
import majicsim.ros.RosHandling;
import majicsim.ros.RosRobot;
import majicsim.world.Pose;
import majicsim.world.Room;
import majicsim.world.Segment;
import majicsim.world.World;

/**
 * The simulated lab: one room, its robots, and their ports on loopback. It answers clients as soon as it is open; its
 * clock advances only in {@link #step()}. All methods may be called from any thread.
 */
public final class Lab implements AutoCloseable {
    /** Lab time of one step. */
    public static final long STEP_NANOS = 4_000_000;

    private static final double STEP_SECONDS = STEP_NANOS / 1e9;

    private final ReentrantLock lock;
    private final World world;
    private final LabTime time;
    private final List<LabRobot> robots;

    private Lab(ReentrantLock lock, World world, LabTime time, List<LabRobot> robots) {
        this.lock = lock;
        this.world = world;
        this.time = time;
        this.robots = robots;
    }

    /**
     * Puts the robots into the room and opens their ports.
     *
     * @param options room, noise and ports
     * @return the open lab, at time 0
     * @throws IOException if a requested port is taken or the room has no place for a robot; the message names it, and
     *     nothing stays open
     */
    public static Lab open(LabOptions options) throws IOException {
        World world = new World(options.room());
        ReentrantLock lock = new ReentrantLock(true);
        LabTime time = new LabTime();
        return new Lab(lock, world, time, new LabSetup(options, world, time, lock).open());
    }

    /** One step: the world, then the firmware of each robot and what is on its lines, if they are due. */
    public void step() {
        lock.lock();
        try {
            world.step(STEP_SECONDS);
            time.step(STEP_NANOS);
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
        return time.nowNanos();
    }

    /**
     * How to reach the robots: "aibo", "pioneer", "hemisson" and "ros" as "127.0.0.1:port", and "pioneer-pty" and
     * "hemisson-pty" as the paths of pseudo-terminals where the system has them. The address of a ROS robot in a
     * namespace has that behind the port. MAVLink vehicles are "mavlink", "mavlink2" and so on, and "mavlink-udp" is
     * where the datagrams of the first one come from.
     *
     * @return addresses by name, in the order of the robots' numbers
     */
    public Map<String, String> addresses() {
        Map<String, String> addresses = new LinkedHashMap<>();
        for (LabRobot robot : robots) {
            for (Port port : robot.ports()) {
                addresses.put(robot.name() + port.suffix(), port.address() + robot.path());
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
        return ofEach(robot -> robot.body().pose());
    }

    /**
     * How often each robot drove into something; being driven into does not count.
     *
     * @return since the lab was opened
     */
    public Map<String, Integer> bumps() {
        return ofEach(robot -> robot.body().bumps());
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
     * The room with everything that does not move.
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
        LabRobot one = named(robot);
        locked(() -> {
            one.body().place(p);
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
        return named(robot).wiring().faults();
    }

    /**
     * Acts on the Pioneer itself: presses its buttons, plugs its charger, reads its buzzer. The lab does not step
     * meanwhile.
     *
     * @param action what to do; must not wait for anything
     */
    public void besidePioneer(Consumer<PioneerHandling> action) {
        beside(PioneerRobot.class, pioneer -> action.accept(pioneer.handling()));
    }

    /**
     * Acts on the Aibo itself: touches it, turns it over, reads what it played. The lab does not step meanwhile.
     *
     * @param action what to do; must not wait for anything
     */
    public void besideAibo(Consumer<AiboHandling> action) {
        beside(AiboRobot.class, aibo -> action.accept(aibo.handling()));
    }

    /**
     * Acts on the Hemisson itself: presses keys of a TV remote, moves its switches, lifts it, switches it off and on.
     * The lab does not step meanwhile.
     *
     * @param action what to do; must not wait for anything
     */
    public void besideHemisson(Consumer<HemissonHandling> action) {
        beside(HemissonRobot.class, hemisson -> action.accept(hemisson.handling()));
    }

    /**
     * Acts on the ROS robot and its computer: faults beside those of its line. The lab does not step meanwhile.
     *
     * @param action what to do; must not wait for anything
     */
    public void besideRos(Consumer<RosHandling> action) {
        beside(RosRobot.class, ros -> action.accept(ros.handling()));
    }

    /**
     * Acts on a MAVLink vehicle itself: its radio pilot, its switch, its battery. The lab does not step meanwhile.
     *
     * @param robot its name
     * @param action what to do; must not wait for anything
     * @throws IllegalArgumentException if there is no such vehicle
     */
    public void besideMavlink(String robot, Consumer<MavlinkHandling> action) {
        LabRobot one = named(robot);
        locked(() -> {
            if (!(one.wiring().firmware() instanceof MavlinkVehicle vehicle)) {
                throw new IllegalArgumentException(robot + " is no MAVLink vehicle");
            }
            action.accept(vehicle.handling());
            return action;
        });
    }

    /**
     * The progress of every line. Cheap and without a lock, for a clock that advances when no data is in transit.
     *
     * @return one entry a line
     */
    public List<LineCount> lines() {
        List<LineCount> lines = new ArrayList<>();
        for (LabRobot robot : robots) {
            for (Port port : robot.ownPorts()) {
                lines.addAll(port.lines());
            }
        }
        return lines;
    }

    /** Closes all ports and lines. */
    @Override
    public synchronized void close() {
        robots.forEach(LabRobot::close);
    }

    private LabRobot named(String robot) {
        return robots.stream()
                .filter(one -> one.name().equals(robot))
                .findFirst()
                .orElseThrow(
                        () -> new IllegalArgumentException("the lab has no robot " + robot + "; it has " + names()));
    }

    private String names() {
        return robots.stream().map(LabRobot::name).collect(Collectors.joining(", "));
    }

    private <T> Map<String, T> ofEach(Function<LabRobot, T> what) {
        return locked(() -> {
            Map<String, T> all = new LinkedHashMap<>();
            robots.forEach(robot -> all.put(robot.name(), what.apply(robot)));
            return all;
        });
    }

    private <R> void beside(Class<R> robot, Consumer<R> action) {
        locked(() -> {
            robots.stream()
                    .filter(one -> !one.isSharing())
                    .map(one -> one.wiring().firmware())
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
