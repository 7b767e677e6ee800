package majic.pioneer.aria;

import com.mobilerobots.Aria.ArRobot;
import java.nio.charset.StandardCharsets;
import majic.bot.BotException;
import majic.pioneer.arcos.ArcosCommand;
import majic.pioneer.arcos.Packet;

/**
 * Executes commands with ARIA's lock held. Those that ARIA repeats or limits by itself are set in ARIA, which sends
 * them in its next cycle; all others are sent at once.
 */
final class AriaCommands {
    /** ARIA's wrapper cannot pass on texts with other bytes than these. */
    private static final int LARGEST_BYTE = 127;

    private AriaCommands() {}

    /**
     * Executes a command.
     *
     * @throws BotException if ARIA cannot send it
     */
    static void execute(ArRobot robot, Packet packet) {
        int value = packet.number();
        ArcosCommand command = ArcosCommand.of(packet.type());
        switch (command) {
            case PULSE -> {} // ARIA sends its own.
            case VEL -> robot.setVel(value);
            case RVEL -> robot.setRotVel(value);
            case STOP -> robot.stop();
            case ESTOP -> emergencyStop(robot, packet);
            case ENABLE -> switchMotors(robot, value != 0);
            case SETV -> robot.setTransVelMax(value);
            case SETRV -> robot.setRotVelMax(value);
            case SETA -> setRamp(value, robot::setTransAccel, robot::setTransDecel);
            case SETRA -> setRamp(value, robot::setRotAccel, robot::setRotDecel);
            default -> send(robot, command, packet);
        }
    }

    /** ARIA would repeat the last velocity half a second later. */
    private static void emergencyStop(ArRobot robot, Packet packet) {
        robot.setVel(0);
        robot.setRotVel(0);
        send(robot, ArcosCommand.ESTOP, packet);
    }

    private static void switchMotors(ArRobot robot, boolean on) {
        if (on) {
            robot.enableMotors();
        } else {
            robot.disableMotors();
        }
    }

    /** A value of ARIA. */
    private interface Ramp {
        void set(double value);
    }

    private static void setRamp(int value, Ramp acceleration, Ramp deceleration) {
        if (value < 0) {
            deceleration.set(-value);
        } else {
            acceleration.set(value);
        }
    }

    private static void send(ArRobot robot, ArcosCommand command, Packet packet) {
        if (!isSent(robot, command, packet)) {
            throw new BotException("ARIA could not send " + command);
        }
    }

    /**
     * Calls a method that an installed ARIA may have with other parameters; then only these commands cannot be sent.
     */
    private static boolean isSent(ArRobot robot, ArcosCommand command, Packet packet) {
        short number = (short) command.number();
        try {
            return switch (command.argument().kind()) {
                case NONE -> robot.com(number);
                case INT -> robot.comInt(number, (short) packet.number());
                case TWO_BYTES -> sendTwoBytes(robot, number, packet.data());
                case STRING -> robot.comStrN(number, text(packet.text()), packet.text().length);
            };
        } catch (LinkageError e) {
            throw new BotException("this ARIA cannot send " + command + ": " + e.getMessage(), e);
        }
    }

    private static boolean sendTwoBytes(ArRobot robot, short number, byte[] data) {
        return robot.com2Bytes(number, (char) (data[2] & 0xFF), (char) (data[1] & 0xFF));
    }

    /** A zero, which is silence in a tune, becomes 1, a note that is too low to be heard. */
    private static String text(byte[] bytes) {
        byte[] sent = bytes.clone();
        for (int at = 0; at < sent.length; at++) {
            if (sent[at] < 0) {
                throw new BotException("ARIA cannot send tones above note " + LARGEST_BYTE + " or longer than 2.54 s");
            }
            sent[at] = sent[at] == 0 ? 1 : sent[at];
        }
        return new String(sent, StandardCharsets.US_ASCII);
    }
}
