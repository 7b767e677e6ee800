package majicsim;

import java.io.IOException;
import java.lang.System.Logger.Level;
import java.net.BindException;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.Function;
import majicsim.aibo.AiboRobot;
import majicsim.hemisson.HemissonRobot;
import majicsim.hemisson.options.HemissonOptions;
import majicsim.mavlink.MavlinkOptions;
import majicsim.mavlink.MavlinkVehicle;
import majicsim.mavlink.VehicleOptions;
import majicsim.net.Clients;
import majicsim.net.Faults;
import majicsim.net.Firmware;
import majicsim.net.FirmwareClock;
import majicsim.net.LabTime;
import majicsim.net.Port;
import majicsim.net.PtyPort;
import majicsim.net.TcpPort;
import majicsim.net.UdpPort;
import majicsim.net.Wiring;
import majicsim.pioneer.PioneerRobot;
import majicsim.ros.RosRobot;
import majicsim.ros.options.RosOptions;
import majicsim.world.Body;
import majicsim.world.Noise;
import majicsim.world.Pose;
import majicsim.world.World;
import org.jspecify.annotations.Nullable;

/** Puts the robots into the room, in the order of their numbers, and opens their ports. For one use. */
final class LabSetup {
    private static final System.Logger LOG = System.getLogger(LabSetup.class.getName());
    private static final Set<Integer> USUAL_PORTS = Set.of(LabPorts.AIBO, LabPorts.PIONEER, LabPorts.ROS);
    private static final double JITTER_FROM_MS = 5;
    private static final double JITTER_TO_MS = 50;

    private final LabOptions options;
    private final World world;
    private final LabTime time;
    private final ReentrantLock lock;
    private final Noise noise;
    private final List<LabRobot> robots = new ArrayList<>();
    private List<Pose> homes = List.of();

    LabSetup(LabOptions options, World world, LabTime time, ReentrantLock lock) {
        this.options = options;
        this.world = world;
        this.time = time;
        this.lock = lock;
        this.noise = options.exact() ? Noise.exact() : Noise.seeded(options.seed());
    }

    /** Returns all robots in order. After a failure no port stays open. */
    List<LabRobot> open() throws IOException {
        try {
            homes = world.room().homes(options.robots());
            add(
                    "aibo",
                    AiboRobot::new,
                    AiboRobot::body,
                    new PortChoice(options.ports().aibo(), Clients.MANY));
            PioneerRobot pioneer = add(
                    "pioneer",
                    this::pioneer,
                    PioneerRobot::body,
                    new PortChoice(options.ports().pioneer(), Clients.ONE));
            addPty(pioneer.serialPort());
            HemissonRobot hemisson = add(
                    "hemisson",
                    this::hemisson,
                    HemissonRobot::body,
                    new PortChoice(options.ports().hemisson(), Clients.ONE));
            addPty(hemisson);
            addRos(options.ros());
            addMavlink(options.mavlink());
            for (int number = 2; number <= options.pioneers(); number++) {
                add("pioneer" + number, this::pioneer, PioneerRobot::body, new PortChoice(0, Clients.ONE));
            }
            return List.copyOf(robots);
        } catch (IllegalArgumentException e) {
            robots.forEach(LabRobot::close);
            throw new IOException("the room cannot hold the robots: " + e.getMessage(), e);
        } catch (IOException e) {
            robots.forEach(LabRobot::close);
            throw e;
        }
    }

    private <R extends Firmware> R add(String name, Maker<R> maker, Function<R, Body> body, PortChoice choice)
            throws IOException {
        Pose home = homes.get(robots.size());
        Noise own = noise.fork(name);
        R robot = maker.make(world, home, own);
        Faults faults = new Faults(own.fork("line"), time);
        if (options.jitter()) {
            faults.jitter(JITTER_FROM_MS, JITTER_TO_MS);
        }
        FirmwareClock clock = new FirmwareClock(robot, time);
        List<Port> ports = new ArrayList<>();
        Wiring wiring = new Wiring(lock, robot, faults, clock::wake, time.add(() -> step(ports)));
        LabRobot added = LabRobot.alone(name, body.apply(robot), wiring, ports);
        robots.add(added);
        added.ports().add(open(name, choice, added.wiring()));
        return robot;
    }

    private void step(List<Port> ports) {
        for (int i = 0; i < ports.size(); i++) {
            ports.get(i).step(time.nowNanos());
        }
    }

    /** Its classes, and those of the JSON library, are loaded only for a lab that has one. */
    private void addRos(@Nullable RosOptions kind) throws IOException {
        if (kind != null) {
            List<Pose> starts = homes.subList(robots.size(), robots.size() + kind.robots());
            RosRobot ros = add(
                    "ros",
                    (in, home, own) -> new RosRobot(in, starts, own, kind),
                    RosRobot::body,
                    new PortChoice(options.ports().ros(), Clients.MANY));
            LabRobot first = robots.remove(robots.size() - 1);
            robots.add(first.at(kind.namespaceOf(0)));
            for (int i = 1; i < kind.robots(); i++) {
                robots.add(first.sharing("ros" + (i + 1), ros.body(i), kind.namespaceOf(i)));
            }
        }
    }

    /** Vehicles with system ids from 1 on, some of which send datagrams too. */
    private void addMavlink(@Nullable MavlinkOptions kinds) throws IOException {
        List<VehicleOptions> vehicles = kinds == null ? List.of() : kinds.vehicles();
        for (int i = 0; i < vehicles.size(); i++) {
            String name = i == 0 ? "mavlink" : "mavlink" + (i + 1);
            int system = i + 1;
            VehicleOptions kind = vehicles.get(i);
            MavlinkVehicle vehicle = add(
                    name,
                    (in, home, own) -> new MavlinkVehicle(name, in, home, own, kind, system),
                    MavlinkVehicle::body,
                    new PortChoice(options.ports().mavlink(i), Clients.ONE));
            if (kind.udpPort() != 0) {
                addUdp(vehicle.radio(), kind.udpPort());
            }
        }
    }

    /** A socket for datagrams for the robot that was added last; its faults are those of its network port too. */
    private void addUdp(Firmware radio, int peerPort) throws IOException {
        LabRobot added = robots.get(robots.size() - 1);
        Wiring own = added.wiring();
        Wiring wiring = new Wiring(lock, radio, own.faults(), own.waking(), own.due());
        added.ports().add(UdpPort.open(peerPort, wiring));
    }

    private PioneerRobot pioneer(World in, Pose home, Noise own) {
        return new PioneerRobot(in, home, own, options.pioneerModel());
    }

    private HemissonRobot hemisson(World in, Pose home, Noise own) {
        HemissonOptions wished = options.hemisson();
        boolean isPaced = options.jitter() && !options.exact();
        return new HemissonRobot(in, home, own, isPaced ? wished.paced() : wished);
    }

    /** A serial port for the robot that was added last; its faults are those of the robot's network port too. */
    private void addPty(Firmware plug) {
        LabRobot added = robots.get(robots.size() - 1);
        Wiring own = added.wiring();
        Wiring wiring = new Wiring(lock, plug, own.faults(), own.waking(), own.due());
        PtyPort.open(wiring).ifPresent(added.ports()::add);
    }

    private static TcpPort open(String name, PortChoice choice, Wiring wiring) throws IOException {
        try {
            return TcpPort.open(choice.port(), choice.clients(), wiring);
        } catch (BindException e) {
            if (!isUsual(choice.port())) {
                throw new IOException(
                        "port " + choice.port() + " for the " + name + " is taken; 0 takes a free one", e);
            }
            LOG.log(Level.INFO, "port {0} is taken, so the {1} takes a free one", String.valueOf(choice.port()), name);
            return TcpPort.open(0, choice.clients(), wiring);
        }
    }

    private static boolean isUsual(int port) {
        int vehicle = (port - LabPorts.MAVLINK) / LabPorts.MAVLINK_STEP;
        return USUAL_PORTS.contains(port) || port == LabPorts.USUAL.mavlink(vehicle) && vehicle >= 0;
    }

    private interface Maker<R> {
        R make(World world, Pose start, Noise noise);
    }

    private record PortChoice(int port, Clients clients) {}
}
