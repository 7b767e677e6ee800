package majicsim.hemisson.firmware;

import majicsim.hemisson.board.CommandBuffer;
import majicsim.hemisson.board.HemissonBoard;
import majicsim.hemisson.board.InfraRedSensors;
import majicsim.hemisson.board.Motors;
import majicsim.hemisson.board.RobotControl;
import majicsim.hemisson.board.SensorTables;
import majicsim.hemisson.uart.Reply;

/** The binary commands {@code !}, {@code &} and {@code *} (sheet 4.3). Their bytes travel as Latin-1 characters. */
final class FastCommands {
    private static final char VERSION = 1;
    private static final char REVISION = 50;

    private final CommandBuffer buffer;
    private final Motors motors;
    private final SensorTables tables;
    private final HemissonBoard board;
    private final RobotControl control;

    FastCommands(CommandBuffer buffer, Motors motors, SensorTables tables, HemissonBoard board, RobotControl control) {
        this.buffer = buffer;
        this.motors = motors;
        this.tables = tables;
        this.board = board;
        this.control = control;
    }

    Reply fresh() {
        return Reply.line("!" + (tables.takeFresh() ? '\1' : '\0'));
    }

    /**
     * Speeds, proximity, light, switches, TV code, version and revision: 22 bytes between the letter and the line end.
     */
    Reply read() {
        StringBuilder reply = new StringBuilder("&");
        reply.append(byteOf(motors.left())).append(byteOf(motors.right()));
        for (int i = 0; i < InfraRedSensors.COUNT; i++) {
            reply.append(byteOf(tables.proximity(i)));
        }
        for (int i = 0; i < InfraRedSensors.COUNT; i++) {
            reply.append(byteOf(tables.ambient(i)));
        }
        reply.append(switchBits()).append(byteOf(board.tvCode));
        return Reply.line(reply.append(VERSION).append(REVISION).toString());
    }

    Reply write() {
        control.drive((byte) buffer.at(1), (byte) buffer.at(2));
        for (int i = 0; i < HemissonBoard.LEDS; i++) {
            board.leds[i] = (buffer.at(3) >> i & 1) == 1;
        }
        return Reply.line("*");
    }

    private char switchBits() {
        int bits = 0;
        for (int i = 0; i < board.switches().length(); i++) {
            bits |= board.switches().charAt(i) == '1' ? 1 << i : 0;
        }
        return (char) bits;
    }

    private static char byteOf(int value) {
        return (char) (value & 0xFF);
    }
}
