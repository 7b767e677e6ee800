package majicsim.hemisson;

import java.util.LinkedHashSet;
import java.util.Set;
import majicsim.hemisson.behaviour.ActiveRunMode;
import majicsim.hemisson.behaviour.RunMode;
import majicsim.hemisson.board.CommandBuffer;
import majicsim.hemisson.board.HemissonBoard;
import majicsim.hemisson.board.InfraRedSensors;
import majicsim.hemisson.board.Motors;
import majicsim.hemisson.board.RobotControl;
import majicsim.hemisson.board.RoomSensors;
import majicsim.hemisson.board.SensorTables;
import majicsim.hemisson.board.TvRemote;
import majicsim.hemisson.firmware.BotStudio;
import majicsim.hemisson.firmware.Commands;
import majicsim.hemisson.firmware.Interpreter;
import majicsim.hemisson.firmware.RoadNarrows;
import majicsim.hemisson.modules.I2cBus;
import majicsim.hemisson.modules.Modules;
import majicsim.hemisson.options.Dialect;
import majicsim.hemisson.options.HemissonOptions;
import majicsim.hemisson.uart.Reply;
import majicsim.hemisson.uart.Uart;
import majicsim.net.Firmware;
import majicsim.net.Line;
import majicsim.world.Body;
import majicsim.world.Noise;
import majicsim.world.Pose;
import majicsim.world.World;
import org.jspecify.annotations.Nullable;

/**
 * A Hemisson with HemiOS 1.50 behind its serial line. It greets after power-up and reset only, on the lines from which
 * something was received, and it has no watchdog: without a client it drives on. It counts as switched on long ago, so
 * a new one sends no greeting. Several lines are one wire: a reply goes to the line whose character completed the
 * command. Every method with the lab's lock held.
 */
public final class HemissonRobot implements Firmware {
    /** The radius of the disc that stands for its body, mm. */
    public static final double RADIUS_MM = 60;

    /** From reset to the first character of the greeting (sheet 3). */
    private static final double BOOT_SECONDS = 0.005;

    private static final String INTERNAL_MODE = "D\u00e9marrage en mode Interne" + Reply.EOL;

    private final Body body;
    private final CommandBuffer buffer;
    private final Motors motors;
    private final SensorTables tables;
    private final HemissonBoard board;
    private final I2cBus bus;
    private final BotStudio botStudio;
    private final Uart uart;
    private final Interpreter interpreter;
    private final ActiveRunMode running;
    private final HemissonHandling handling;

    /**
     * The lines from which something was received: a serial port that is not open would keep the greeting for the next
     * client.
     */
    private final Set<Line> listeners = new LinkedHashSet<>();

    private boolean restarting;

    /**
     * A robot without modules and without the real robot's weaknesses.
     *
     * @param world the room; the robot adds its body
     * @param start its start pose
     * @param noise of its motors and sensors
     * @throws IllegalArgumentException if it does not fit there
     */
    public HemissonRobot(World world, Pose start, Noise noise) {
        this(world, start, noise, HemissonOptions.standard());
    }

    /**
     * A robot with options.
     *
     * @param world the room; the robot adds its body
     * @param start its start pose
     * @param noise of its motors and sensors
     * @param options its firmware, switches and modules, and which weaknesses of the real robot it has
     * @throws IllegalArgumentException if it does not fit there
     */
    public HemissonRobot(World world, Pose start, Noise noise, HemissonOptions options) {
        this(world, Body.disc("hemisson", RADIUS_MM, start), noise, options, null);
    }

    HemissonRobot(World world, Body body, Noise noise, HemissonOptions options, @Nullable InfraRedSensors sensors) {
        world.add(body);
        this.body = body;
        buffer = new CommandBuffer(options.dialect() == Dialect.KTEAM);
        motors = new Motors(body, noise.fork("motors"), options.mismatchPercent());
        RoomSensors roomSensors = new RoomSensors(world, body, noise.fork("infra-red"), options.ambient());
        tables = new SensorTables(sensors == null ? roomSensors : sensors, buffer);
        board = new HemissonBoard(options.switches());
        Modules modules = new Modules(world, body);
        bus = new I2cBus(modules.fitted(options.modules()));
        botStudio = new BotStudio(motors, board, tables);
        uart = new Uart(options);
        interpreter = interpreter(options.dialect(), new Controls());
        running = new ActiveRunMode(motors, board, tables);
        handling = new HemissonHandling(this, board, motors, roomSensors, modules);
        startMode();
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
     * Physical access to it.
     *
     * @return the same object at every call
     */
    public HemissonHandling handling() {
        return handling;
    }

    @Override
    public void disconnected(Line line) {
        listeners.remove(line);
    }

    @Override
    public void received(Line line, byte[] bytes) {
        listeners.add(line);
        uart.arrive(line, bytes);
        listen(false);
    }

    @Override
    public void step(double seconds) {
        uart.step(seconds);
        board.step(seconds);
        bus.step(seconds);
        listen(true);
        running.behaviour().step(seconds);
        if (tables.step(seconds)) {
            board.readSwitches();
            running.behaviour().sensorsRead();
        }
    }

    @Override
    public long restNanos() {
        boolean idle = uart.isIdle() && bus.isIdle() && running.behaviour().isIdle();
        return idle ? (long) (tables.restSeconds() * 1e9) : 0;
    }

    boolean isReceiverBlocked() {
        return uart.isReceiverBlocked() || buffer.isStuck();
    }

    boolean takesCommands() {
        return !isReceiverBlocked() && !botStudio.isTakingBytes();
    }

    void powerCycle() {
        uart.powerCycle();
        bus.powerCycle();
        restart();
    }

    void pressTvKey(int key) {
        board.tvCode = key;
        if (running.mode() == RunMode.REMOTE) {
            TvRemote.drive(key, motors);
        }
    }

    private Interpreter interpreter(Dialect dialect, RobotControl control) {
        Commands stock = new Commands(buffer, motors, tables, board, bus, botStudio, control);
        return switch (dialect) {
            case KTEAM -> stock;
            case ROADNARROWS -> new RoadNarrows(buffer, stock, motors, bus, control);
        };
    }

    private void listen(boolean inStep) {
        for (Uart.Arrival a = uart.next(inStep); a != null; a = uart.next(inStep)) {
            if (botStudio.isTakingBytes()) {
                uart.reply(a.from(), botStudio.take(a.character()));
            } else {
                take(a);
            }
        }
    }

    /**
     * A command is looked for only when the receiver is empty, so a character behind the CR, taken together with it,
     * hides it.
     */
    private void take(Uart.Arrival arrival) {
        buffer.put(arrival.character());
        if (!uart.hasMore() && buffer.takeCommand()) {
            uart.reply(arrival.from(), interpreter.carryOut());
            if (restarting) {
                restarting = false;
                restart();
            }
        }
    }

    private void restart() {
        motors.set(0, 0);
        buffer.clear();
        board.reset();
        botStudio.reset();
        tables.refresh();
        startMode();
        uart.busyFor(BOOT_SECONDS);
        String greeting = interpreter.greeting() + (running.mode().isInternal() ? INTERNAL_MODE : "");
        uart.announce(listeners, greeting);
    }

    private void startMode() {
        running.start(board.switches());
        uart.lookRarely(running.mode() == RunMode.OTHER);
    }

    private final class Controls implements RobotControl {
        @Override
        public void drive(int left, int right) {
            if (!running.mode().holdsMotors()) {
                motors.set(left, right);
            }
        }

        @Override
        public void reset() {
            restarting = true;
        }
    }
}
