package majicsim.hemisson;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import majicsim.hemisson.board.InfraRedSensors;
import majicsim.hemisson.options.HemissonOptions;
import majicsim.net.Line;
import majicsim.world.Body;
import majicsim.world.Noise;
import majicsim.world.Pose;
import majicsim.world.Room;
import majicsim.world.World;
import org.jspecify.annotations.Nullable;

/**
 * A Hemisson and its client in one thread: what it answers is there at once, or after a step. In text, ␍ and ␊ are CR
 * and LF.
 */
public final class Desk implements Line {
    public static final Pose START = new Pose(-2000, -2000, 0);
    private static final double STEP_SECONDS = 0.004;

    final World world = new World(Room.standard());
    public final HemissonRobot robot;
    private final StringBuilder heard = new StringBuilder();

    /** With the sheet's made-up sensor values. */
    public Desk(HemissonOptions options) {
        this(options, Desk::madeUp, Noise.exact());
    }

    Desk(HemissonOptions options, @Nullable InfraRedSensors sensors, Noise noise) {
        Body body = Body.disc("hemisson", HemissonRobot.RADIUS_MM, START);
        robot = new HemissonRobot(world, body, noise, options, sensors);
        robot.received(this, new byte[0]);
    }

    /** With sensors that see the standard room, without noise. */
    public static Desk inTheRoom(HemissonOptions options) {
        return new Desk(options, null, Noise.exact());
    }

    /** Sends all of it in one go; returns what was answered at once. */
    public String say(String text) {
        byte[] bytes = text.replace('␍', '\r').replace('␊', '\n').getBytes(StandardCharsets.ISO_8859_1);
        robot.received(this, bytes);
        return take();
    }

    /** Sends one command with its CR, waits a lab step, and returns the answer without its line end. */
    public String ask(String command) {
        String answer = say(command + "␍");
        String all = answer + after(STEP_SECONDS);
        return all.endsWith("␍␊") ? all.substring(0, all.length() - 2) : all;
    }

    /** Lets time pass in lab steps; returns what was received meanwhile. */
    public String after(double seconds) {
        for (long i = Math.round(seconds / STEP_SECONDS); i > 0; i--) {
            world.step(STEP_SECONDS);
            robot.step(STEP_SECONDS);
        }
        return take();
    }

    /** Lets time pass in one small step, finer than the lab's. */
    public String tick(double seconds) {
        robot.step(seconds);
        return take();
    }

    @Override
    public void send(byte[] message) {
        heard.append(new String(message, StandardCharsets.ISO_8859_1));
    }

    @Override
    public String peer() {
        return "desk";
    }

    @Override
    public void close() {
        robot.disconnected(this);
    }

    @Override
    public boolean isOpen() {
        return true;
    }

    private String take() {
        String taken = heard.toString().replace('\r', '␍').replace('\n', '␊');
        heard.setLength(0);
        return taken;
    }

    private static void madeUp(int[] ambient, int[] response) {
        Arrays.fill(ambient, 220);
        Arrays.fill(response, 0, 6, 4);
        Arrays.fill(response, 6, 8, 60);
    }
}
