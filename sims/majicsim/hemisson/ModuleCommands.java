package majicsim.hemisson;

import java.util.Locale;

/** The commands that reach the I²C bus: J, R, W, Y. */
final class ModuleCommands {
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
    String scan() {
        StringBuilder reply = new StringBuilder("j");
        bus.addresses().forEach(address -> reply.append(String.format(Locale.ROOT, ",%02x", address)));
        return reply.append(Commands.EOL).toString();
    }

    String read() {
        int address = buffer.hex(ADDRESS);
        int register = buffer.hex(REGISTER);
        StringBuilder reply = new StringBuilder("r");
        for (int i = 0; i < buffer.hex(VALUE); i++) {
            reply.append(',').append(Commands.threeDigits(bus.read(address, register, i)));
        }
        return reply.append(Commands.EOL).toString();
    }

    String write() {
        bus.write(buffer.hex(ADDRESS), buffer.hex(REGISTER), buffer.hex(VALUE));
        return "w" + Commands.EOL;
    }

    /** Sends the count too, as the first byte. */
    String writeMany() {
        int address = buffer.hex(ADDRESS);
        int register = buffer.hex(REGISTER);
        int count = buffer.hex(VALUE);
        bus.write(address, register, count);
        for (int i = 0; i < count && MORE + 3 * i + 1 < CommandBuffer.SIZE; i++) {
            bus.write(address, register + 1 + i, buffer.hex(MORE + 3 * i));
        }
        return "y" + Commands.EOL;
    }
}
