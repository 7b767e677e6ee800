package majicsim.hemisson.firmware;

import java.util.Locale;
import majicsim.hemisson.board.CommandBuffer;
import majicsim.hemisson.modules.I2cBus;
import majicsim.hemisson.uart.Reply;

/** The commands that reach the I²C bus: J, R, W, Y. */
final class ModuleCommands {
    /** From the sheet's 18 ms for a whole scan (4.6). */
    static final double SCAN_SECONDS = 0.0177;

    private static final double TALK_SECONDS = 400e-6;
    private static final int ADDRESS = 2;
    private static final int REGISTER = 5;
    private static final int VALUE = 8;
    private static final int MORE = 11;

    private final CommandBuffer buffer;
    private final I2cBus bus;

    ModuleCommands(CommandBuffer buffer, I2cBus bus) {
        this.buffer = buffer;
        this.bus = bus;
    }

    /** Addresses come in lower-case hex here. */
    Reply scan() {
        StringBuilder reply = new StringBuilder("j");
        bus.awake().forEach(module -> reply.append(String.format(Locale.ROOT, ",%02x", module.address())));
        return Reply.line(reply.toString()).scanning(SCAN_SECONDS);
    }

    /** A count of 0 reads one register. */
    Reply read() {
        int address = buffer.hex(ADDRESS);
        int register = buffer.hex(REGISTER);
        StringBuilder reply = new StringBuilder("r");
        int count = Math.max(1, buffer.hex(VALUE));
        for (int i = 0; i < count; i++) {
            reply.append(',').append(Commands.threeDigits(bus.read(address, register, i)));
        }
        return Reply.line(reply.toString()).thinking(TALK_SECONDS);
    }

    Reply write() {
        bus.write(buffer.hex(ADDRESS), buffer.hex(REGISTER), buffer.hex(VALUE));
        return Reply.line("w").thinking(TALK_SECONDS);
    }

    /** Sends the count too, as the first byte. */
    Reply writeMany() {
        int fits = (CommandBuffer.SIZE - MORE) / 3;
        int count = buffer.hex(VALUE);
        int[] bytes = new int[1 + Math.min(count, fits)];
        bytes[0] = count;
        for (int i = 1; i < bytes.length; i++) {
            bytes[i] = buffer.hex(MORE + 3 * (i - 1));
        }
        bus.write(buffer.hex(ADDRESS), buffer.hex(REGISTER), bytes);
        return Reply.line("y").thinking(TALK_SECONDS);
    }
}
