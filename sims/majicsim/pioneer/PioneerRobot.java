package majicsim.pioneer;

import java.util.List;
import java.util.Locale;
import majicsim.net.Firmware;
import majicsim.net.Line;
import majicsim.pioneer.board.Board;
import majicsim.pioneer.model.PioneerModel;
import majicsim.pioneer.serial.SerialWire;
import majicsim.pioneer.session.Session;
import majicsim.world.Body;
import majicsim.world.Noise;
import majicsim.world.Pose;
import majicsim.world.World;
import org.jspecify.annotations.Nullable;

/**
 * A Pioneer with an ARCOS controller. Serves one client at a time: as firmware of a network port it closes the line at
 * CLOSE and stops when the client disconnects; its {@link #serialPort()} behaves like the serial port of the real
 * robot. Every call must hold the lab's lock.
 */
public final class PioneerRobot implements Firmware {
    private static final System.Logger LOG = System.getLogger(PioneerRobot.class.getName());

    /** A plain Pioneer 3-DX with its present controller, as most labs have it: the model unless another is given. */
    public static final String STANDARD_MODEL = "p3dx-sh";

    private static final String OWNERS_NAME = "MajicSim";

    private final Body body;
    private final Board board;
    private final PioneerHandling handling;
    private final SerialPort serialPort;
    private @Nullable Session session;

    /**
     * A Pioneer of the {@link #STANDARD_MODEL}, put into the world.
     *
     * @param world the room
     * @param start its start pose
     * @param noise the lab's source of chance; exact: wheels, sonar and odometry without error
     * @throws IllegalArgumentException if the start pose is not free; nothing was added
     */
    public PioneerRobot(World world, Pose start, Noise noise) {
        this(world, start, noise, STANDARD_MODEL);
    }

    /**
     * A Pioneer of the given model, put into the world.
     *
     * @param world the room
     * @param start its start pose
     * @param noise the lab's source of chance; exact: wheels, sonar and odometry without error
     * @param name the model by the name it has in the handshake, one of {@link #models()}, with its extras as in
     *     {@link #modelNamed}
     * @throws IllegalArgumentException if there is no such model, or the start pose is not free; nothing was added
     */
    public PioneerRobot(World world, Pose start, Noise noise, String name) {
        PioneerModel model = PioneerModel.of(name);
        body = Body.box("pioneer", model.frontMm(), model.rearMm(), model.halfWidthMm(), start);
        world.add(body);
        board = new Board(world, body, model, OWNERS_NAME, noise.fork("pioneer"));
        serialPort = new SerialPort(!noise.isExact());
        handling = new PioneerHandling(board.devices(), this::restart);
    }

    /**
     * All models.
     *
     * @return their subclasses, as the handshake names them
     */
    public static List<String> models() {
        return PioneerModel.subclasses();
    }

    /**
     * Checks the name of a model, behind which extras may be named after plus signs: {@code gripper}, {@code gyro},
     * {@code charger}, {@code compass}, {@code bumpers}.
     *
     * @param name such as {@code p3dx-sh} or {@code P3DX-SH+gripper}
     * @return the same in lower case, as the handshake has it
     * @throws IllegalArgumentException if there is no such model or extra; the message lists the valid ones
     */
    public static String modelNamed(String name) {
        PioneerModel.of(name);
        return name.toLowerCase(Locale.ROOT);
    }

    /**
     * Its body in the world.
     *
     * @return the body that was added
     */
    public Body body() {
        return body;
    }

    /**
     * Physical access to it: buttons, plugs, inputs.
     *
     * @return the same for the life of the robot
     */
    public PioneerHandling handling() {
        return handling;
    }

    /**
     * The speed that its serial port has now; 9600 until a client changes it with HOSTBAUD (ARCOS sheet 6.1).
     *
     * @return bits a second
     */
    public int hostBaud() {
        return board.devices().hostBaud().bitsPerSecond();
    }

    /**
     * The robot's serial port, in place of the network: CLOSE leaves the line open for the next handshake, and a client
     * that disconnects is detected only by the watchdog (ARCOS sheet 5.1). Its input is ignored while a network client
     * is connected; a network client can replace its client only after a silence as long as the watchdog's time.
     *
     * @return firmware for a serial line; its steps do nothing, this robot's own step serves both
     */
    public Firmware serialPort() {
        return serialPort;
    }

    @Override
    public void connected(Line line) {
        if (session != null && session.isUnderWay()) {
            if (!session.hasTimedOut()) {
                LOG.log(
                        System.Logger.Level.INFO,
                        "pioneer: {0} is turned away, the serial line is in use",
                        line.peer());
                line.close();
                return;
            }
            session.close();
        }
        session = new Session(line, board, true);
    }

    @Override
    public void received(Line line, byte[] bytes) {
        if (session != null && session.isOn(line)) {
            session.received(bytes);
            forgetEnded();
        }
    }

    @Override
    public void disconnected(Line line) {
        if (session != null && session.isOn(line)) {
            session.close();
            session = null;
        }
    }

    @Override
    public void step(double seconds) {
        long nanos = Math.round(seconds * 1e9);
        board.step(seconds);
        serialPort.wire.step(nanos);
        if (session != null) {
            session.step(nanos);
            forgetEnded();
        }
    }

    @Override
    public long restNanos() {
        long rest = board.restNanos();
        if (rest == 0 || !serialPort.wire.isIdle()) {
            return 0;
        }
        return session == null ? rest : Math.min(rest, session.restNanos());
    }

    @Override
    public void rest(long nanos) {
        board.rest(nanos);
        if (session != null) {
            session.step(nanos);
        }
    }

    /**
     * The controller board, for tests.
     *
     * @return the same object at every call
     */
    public Board board() {
        return board;
    }

    private void restart() {
        if (session != null) {
            session.restart();
        } else {
            board.restart();
        }
    }

    private void forgetEnded() {
        if (session != null && session.hasEnded()) {
            session = null;
        }
    }

    /** The serial port: the controller uses the same line for all clients. */
    private final class SerialPort implements Firmware {
        private final SerialWire wire;

        SerialPort(boolean takesTime) {
            wire = new SerialWire(board.devices().hostBaud(), takesTime, this::heard);
        }

        @Override
        public void connected(Line line) {
            wire.plugIn(line);
        }

        @Override
        public void received(Line line, byte[] bytes) {
            wire.arrive(bytes);
        }

        @Override
        public void step(double seconds) {
            // The robot's own step serves every line.
        }

        private void heard(byte[] bytes) {
            if (session == null) {
                session = new Session(wire, board, false);
            }
            if (session.isOn(wire)) {
                session.received(bytes);
            }
        }
    }
}
