package majicsim.hemisson.firmware;

import majicsim.hemisson.board.CommandBuffer;
import majicsim.hemisson.board.Eyes;
import majicsim.hemisson.board.HemissonBoard;
import majicsim.hemisson.board.InfraRed;
import majicsim.hemisson.board.Motors;
import majicsim.hemisson.board.Power;
import majicsim.hemisson.uart.Reply;

/** The binary commands {@code !}, {@code &} and {@code *} (sheet 4.3). Their bytes travel as Latin-1 characters. */
final class FastCommands {
    private static final char VERSION = 1;
    private static final char REVISION = 50;

    private final CommandBuffer buffer;
    private final Motors motors;
    private final InfraRed infraRed;
    private final HemissonBoard board;
    private final Power power;

    FastCommands(CommandBuffer buffer, Motors motors, InfraRed infraRed, HemissonBoard board, Power power) {
        this.buffer = buffer;
        this.motors = motors;
        this.infraRed = infraRed;
        this.board = board;
        this.power = power;
    }

    Reply fresh() {
        return Reply.line("!" + (infraRed.takeFresh() ? '\1' : '\0'));
    }

    /** Speeds, proximity, light, switches, TV code, version and revision: 22 bytes between the letter and the line end. */
    Reply read() {
        StringBuilder reply = new StringBuilder("&");
        reply.append(byteOf(motors.left())).append(byteOf(motors.right()));
        for (int i = 0; i < Eyes.COUNT; i++) {
            reply.append(byteOf(infraRed.proximity(i)));
        }
        for (int i = 0; i < Eyes.COUNT; i++) {
            reply.append(byteOf(infraRed.ambient(i)));
        }
        reply.append(switchBits()).append(byteOf(board.tvCode));
        return Reply.line(reply.append(VERSION).append(REVISION).toString());
    }

    Reply write() {
        power.drive((byte) buffer.at(1), (byte) buffer.at(2));
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
