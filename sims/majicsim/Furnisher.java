package majicsim;

import java.io.IOException;
import java.lang.System.Logger.Level;
import java.net.BindException;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.Function;
import majicsim.aibo.AiboRobot;
import majicsim.hemisson.HemissonRobot;
import majicsim.hemisson.options.HemissonOptions;
import majicsim.net.Clients;
import majicsim.net.Faults;
import majicsim.net.Firmware;
import majicsim.net.PtyPort;
import majicsim.net.TcpPort;
import majicsim.net.Wiring;
import majicsim.pioneer.PioneerRobot;
import majicsim.world.Body;
import majicsim.world.Noise;
import majicsim.world.Pose;
import majicsim.world.World;

/** Puts the robots into the room, in the order of their numbers, and opens their ports. For one use. */
final class Furnisher {
    private static final System.Logger LOG = System.getLogger(Furnisher.class.getName());
    private static final double JITTER_FROM_MS = 5;
    private static final double JITTER_TO_MS = 50;

    private final LabOptions options;
    private final World world;
    private final ReentrantLock lock;
    private final Noise noise;
    private final List<Station> stations = new ArrayList<>();

    Furnisher(LabOptions options, World world, ReentrantLock lock) {
        this.options = options;
        this.world = world;
        this.lock = lock;
        this.noise = options.exact() ? Noise.exact() : Noise.seeded(options.seed());
    }

    /** All stations in order; after a failure none is left open. */
    List<Station> furnish() throws IOException {
        try {
            add(
                    "aibo",
                    AiboRobot::new,
                    AiboRobot::body,
                    new Door(options.ports().aibo(), Clients.MANY));
            PioneerRobot pioneer = add(
                    "pioneer",
                    this::pioneer,
                    PioneerRobot::body,
                    new Door(options.ports().pioneer(), Clients.ONE));
            addPty(pioneer.serialPort());
            HemissonRobot hemisson = add(
                    "hemisson",
                    this::hemisson,
                    HemissonRobot::body,
                    new Door(options.ports().hemisson(), Clients.ONE));
            addPty(hemisson);
            for (int number = 2; number <= options.pioneers(); number++) {
                add("pioneer" + number, this::pioneer, PioneerRobot::body, new Door(0, Clients.ONE));
            }
            return List.copyOf(stations);
        } catch (IllegalArgumentException e) {
            stations.forEach(Station::close);
            throw new IOException("the room cannot hold the robots: " + e.getMessage(), e);
        } catch (IOException e) {
            stations.forEach(Station::close);
            throw e;
        }
    }

    private <R extends Firmware> R add(String name, Maker<R> maker, Function<R, Body> body, Door door)
            throws IOException {
        Pose home = world.room().home(stations.size() + 1);
        Noise own = noise.fork(name);
        R robot = maker.make(world, home, own);
        Faults faults = new Faults(own.fork("line"));
        if (options.jitter()) {
            faults.jitter(JITTER_FROM_MS, JITTER_TO_MS);
        }
        Station station = new Station(name, body.apply(robot), new Wiring(lock, robot, faults), new ArrayList<>());
        stations.add(station);
        station.ports().add(open(name, door, station.wiring()));
        return robot;
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
        Station station = stations.get(stations.size() - 1);
        Wiring wiring = new Wiring(lock, plug, station.wiring().faults());
        PtyPort.open(wiring).ifPresent(station.ports()::add);
    }

    private static TcpPort open(String name, Door door, Wiring wiring) throws IOException {
        try {
            return TcpPort.open(door.port(), door.clients(), wiring);
        } catch (BindException e) {
            if (door.port() != LabPorts.AIBO && door.port() != LabPorts.PIONEER) {
                throw new IOException("port " + door.port() + " for the " + name + " is taken; 0 takes a free one", e);
            }
            LOG.log(Level.INFO, "port {0} is taken, so the {1} takes a free one", String.valueOf(door.port()), name);
            return TcpPort.open(0, door.clients(), wiring);
        }
    }

    private interface Maker<R> {
        R make(World world, Pose start, Noise noise);
    }

    private record Door(int port, Clients clients) {}
}
