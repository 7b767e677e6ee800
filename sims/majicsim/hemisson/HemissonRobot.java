package majicsim.hemisson;

import java.util.LinkedHashSet;
import java.util.Set;
import majicsim.hemisson.behaviour.Modes;
import majicsim.hemisson.behaviour.RunMode;
import majicsim.hemisson.board.CommandBuffer;
import majicsim.hemisson.board.Eyes;
import majicsim.hemisson.board.HemissonBoard;
import majicsim.hemisson.board.InfraRed;
import majicsim.hemisson.board.Motors;
import majicsim.hemisson.board.Power;
import majicsim.hemisson.board.TvRemote;
import majicsim.hemisson.board.WorldEyes;
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
 * A Hemisson with HemiOS 1.50 behind its serial line. It greets after power-up and reset only, on the lines from which something
 * was received, and it has no watchdog: without a client it drives on. It was switched on long ago, so a new one does not greet.
 * Several lines are one wire: a reply goes to the line whose character completed the command. Every method with the lab's lock
 * held.
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
    private final InfraRed infraRed;
    private final HemissonBoard board;
    private final I2cBus bus;
    private final BotStudio botStudio;
    private final Uart uart;
    private final Interpreter interpreter;
    private final Modes modes;
    private final HemissonHandling handling;

    /** The lines from which something was received: a plug that is not open would keep the greeting for the next client. */
    private final Set<Line> listeners = new LinkedHashSet<>();

    private boolean restarting;

    /**
     * A forgiving robot without modules.
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
     * A robot with options.
     *
     * @param world where it drives; the robot adds its body
     * @param start where it stands first
     * @param noise of its motors and sensors
     * @param options its firmware, switches and modules, and how forgiving it is
     * @throws IllegalArgumentException if it does not fit there
     */
    public HemissonRobot(World world, Pose start, Noise noise, HemissonOptions options) {
        this(world, Body.disc("hemisson", RADIUS_MM, start), noise, options, null);
    }

    HemissonRobot(World world, Body body, Noise noise, HemissonOptions options, @Nullable Eyes eyes) {
        world.add(body);
        this.body = body;
        buffer = new CommandBuffer(options.dialect() == Dialect.KTEAM);
        motors = new Motors(body, noise.fork("motors"), options.mismatchPercent());
        WorldEyes worldEyes = new WorldEyes(world, body, noise.fork("infra-red"), options.ambient());
        infraRed = new InfraRed(eyes == null ? worldEyes : eyes, buffer);
        board = new HemissonBoard(options.switches());
        Modules modules = new Modules(world, body);
        bus = new I2cBus(modules.fitted(options.modules()));
        botStudio = new BotStudio(motors, board, infraRed);
        uart = new Uart(options);
        interpreter = interpreter(options.dialect(), new Controls());
        modes = new Modes(motors, board, infraRed);
        handling = new HemissonHandling(this, board, motors, worldEyes, modules);
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
     * What can be done to the robot itself.
     *
     * @return the person beside it
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
        modes.behaviour().step(seconds);
        if (infraRed.step(seconds)) {
            board.readSwitches();
            modes.behaviour().look();
        }
    }

    boolean isReceiverBlocked() {
        return uart.isReceiverBlocked() || buffer.isStuck();
    }

    void powerCycle() {
        uart.powerCycle();
        bus.powerCycle();
        restart();
    }

    void pressTvKey(int key) {
        board.tvCode = key;
        if (modes.mode() == RunMode.REMOTE) {
            TvRemote.drive(key, motors);
        }
    }

    private Interpreter interpreter(Dialect dialect, Power power) {
        Commands stock = new Commands(buffer, motors, infraRed, board, bus, botStudio, power);
        return switch (dialect) {
            case KTEAM -> stock;
            case ROADNARROWS -> new RoadNarrows(buffer, stock, motors, bus, power);
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

    /** A command is looked for only when the receiver is empty, so a character behind the CR, taken together with it, hides it. */
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
        infraRed.refresh();
        startMode();
        uart.busyFor(BOOT_SECONDS);
        String greeting = interpreter.greeting() + (modes.mode().isInternal() ? INTERNAL_MODE : "");
        uart.announce(listeners, greeting);
    }

    private void startMode() {
        modes.start(board.switches());
        uart.lookRarely(modes.mode() == RunMode.OTHER);
    }

    private final class Controls implements Power {
        @Override
        public void drive(int left, int right) {
            if (!modes.mode().holdsMotors()) {
                motors.set(left, right);
            }
        }

        @Override
        public void reset() {
            restarting = true;
        }
    }
}
