package majicsim.hemisson;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import majicsim.net.Firmware;
import majicsim.net.Line;
import majicsim.world.Body;
import majicsim.world.Noise;
import majicsim.world.Pose;
import majicsim.world.World;
import org.jspecify.annotations.Nullable;

/**
 * A Hemisson with HemiOS 1.50 behind its serial line. It greets after power-up and reset only, to whoever listens then, and it has no
 * watchdog: without a client it drives on. Several lines are one wire: a reply goes to the line whose character completed the
 * command. Every method with the lab's lock held.
 */
public final class HemissonRobot implements Firmware {
    /** The radius of the disc that stands for its body, mm. */
    public static final double RADIUS_MM = 60;

    private static final double BOOT_SECONDS = 0.008;
    private static final int TABLES_BEGIN = 51;
    private static final String GREETING = "HemiOS V1.50 , K-Team S.A. ( Alexandre Colot )  30-Aug-04 @ 09:37:30\r\n"
            + "E-Mail : info@hemisson.com\r\n\r\n";
    private static final String INTERNAL_MODE = "D\u00e9marrage en mode Interne\r\n";

    private final Body body;
    private final CommandBuffer buffer = new CommandBuffer();
    private final Motors motors;
    private final InfraRed infraRed;
    private final Board board;
    private final I2cBus bus;
    private final Uart uart;
    private final Commands commands;
    private final Set<Line> lines = new LinkedHashSet<>();
    private RunMode mode;
    private double bootSeconds;

    /**
     * A forgiving robot without modules, just switched on.
     *
     * @param world where it drives; the robot adds its body
     * @param start where it stands first
     * @param noise of its motors and sensors
     * @throws IllegalArgumentException if it does not fit there
     */
    public HemissonRobot(World world, Pose start, Noise noise) {
        this(world, start, noise, HemissonOptions.standard());
    }

    /**
     * A robot with options, just switched on.
     *
     * @param world where it drives; the robot adds its body
     * @param start where it stands first
     * @param noise of its motors and sensors
     * @param options switches, modules and how forgiving it is
     * @throws IllegalArgumentException if it does not fit there
     */
    public HemissonRobot(World world, Pose start, Noise noise, HemissonOptions options) {
        this(world, Body.disc("hemisson", RADIUS_MM, start), noise, options, null);
    }

    HemissonRobot(World world, Body body, Noise noise, HemissonOptions options, @Nullable Eyes eyes) {
        world.add(body);
        this.body = body;
        motors = new Motors(body, noise.fork("motors"));
        infraRed = new InfraRed(eyes == null ? new WorldEyes(world, body, noise.fork("infra-red")) : eyes);
        board = new Board(options.switches());
        bus = new I2cBus(
                options.modules() ? List.of(new LinearCamera(world, body), new Ultrasonic(world, body)) : List.of());
        uart = new Uart(options);
        commands = new Commands(buffer, motors, infraRed, board, bus, new Controls());
        mode = RunMode.of(options.switches());
    }

    /**
     * Its body in the world.
     *
     * @return the body, named hemisson
     */
    public Body body() {
        return body;
    }

    /**
     * Its LEDs: On/Off, Pgm/Exec, front left, front right.
     *
     * @return four states
     */
    public List<Boolean> leds() {
        return List.of(board.leds[0], board.leds[1], board.leds[2], board.leds[3]);
    }

    /**
     * Whether its buzzer sounds.
     *
     * @return true while it does
     */
    public boolean isBuzzing() {
        return board.buzzer;
    }

    /**
     * Whether it has stopped listening for good, until {@link #powerCycle()}.
     *
     * @return true when it hears nothing any more
     */
    public boolean isDeaf() {
        return uart.isDeaf() || buffer.isStuck();
    }

    /** Switches it off and on: motors 0, everything forgotten, hearing again; greets shortly after. */
    public void powerCycle() {
        uart.powerCycle();
        restart();
    }

    /**
     * Moves its four top switches; the firmware reads them within 41 ms, its running mode only at the next start.
     *
     * @param switches four characters 0 or 1, in the order of command I
     */
    public void moveSwitches(String switches) {
        board.moveSwitches(switches);
    }

    /**
     * Somebody points a TV remote at it. In remote control mode keys 1 to 9 drive (sheet 8).
     *
     * @param key code of the key, 0 to 63
     */
    public void pressTvKey(int key) {
        board.tvCode = key;
        if (mode == RunMode.REMOTE) {
            TvRemote.drive(key, motors);
        }
    }

    @Override
    public void connected(Line line) {
        lines.add(line);
    }

    @Override
    public void disconnected(Line line) {
        lines.remove(line);
    }

    @Override
    public void received(Line line, byte[] bytes) {
        uart.arrive(line, bytes);
        listen();
    }

    @Override
    public void step(double seconds) {
        boot(seconds);
        uart.step(seconds);
        bus.step(seconds);
        if (infraRed.step(seconds)) {
            board.readSwitches();
        }
        listen();
    }

    private void listen() {
        while (uart.hasNext()) {
            Uart.Arrival arrival = uart.next();
            infraRed.overwrite(buffer.position() - TABLES_BEGIN, arrival.character());
            if (buffer.put(arrival.character())) {
                String reply = commands.carryOut();
                if (!reply.isEmpty()) {
                    uart.reply(arrival.from(), reply);
                }
            }
        }
    }

    private void restart() {
        motors.set(0, 0);
        buffer.clear();
        board.reset();
        mode = RunMode.of(board.switches());
        bootSeconds = BOOT_SECONDS;
    }

    /** The greeting comes some milliseconds after power-up or reset. */
    private void boot(double seconds) {
        if (bootSeconds <= 0) {
            return;
        }
        bootSeconds -= seconds;
        if (bootSeconds < seconds / 2) {
            bootSeconds = 0;
            String greeting = mode == RunMode.REMOTE ? GREETING : GREETING + INTERNAL_MODE;
            lines.forEach(line -> uart.reply(line, greeting));
        }
    }

    private final class Controls implements Power {
        @Override
        public void drive(int left, int right) {
            if (mode == RunMode.REMOTE) {
                motors.set(left, right);
            }
        }

        @Override
        public void reset() {
            restart();
        }

        @Override
        public void deafen() {
            uart.deafen();
        }
    }
}
