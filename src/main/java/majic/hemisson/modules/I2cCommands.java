package majic.hemisson.modules;

import java.util.List;
import java.util.stream.Collectors;
import majic.bot.BotException;
import majic.bot.Parameter;
import majic.bot.Unit;
import majic.bot.Value;
import majic.driver.DriverCommand;
import majic.driver.Motion;
import majic.hemisson.line.Question;
import majic.hemisson.readings.RobotReadings;

/**
 * Raw reading and writing on the I2C bus, for modules without commands of their own. Reading moves nothing; writing may
 * move an attached device, so it needs the permission to move.
 */
public final class I2cCommands {
    private static final int HEX = 16;
    private static final int LOWEST = 0x02;
    private static final int HIGHEST = 0xFC;

    private final RobotReadings access;

    public I2cCommands(RobotReadings access) {
        this.access = access;
    }

    public List<DriverCommand> all() {
        Parameter address = Parameter.text("address", "the write address of the module, hex: C0");
        Parameter register = Parameter.text("register", "hex");
        Parameter count = Parameter.number("count", Unit.NONE, "how many registers")
                .within(1, Bus.MOST_REGISTERS)
                .inWholes();
        Parameter value = Parameter.text("byte", "hex");
        return List.of(
                new DriverCommand(
                                "i2cRead",
                                List.of(address, register, count),
                                false,
                                "shows registers of a module; 255 where there is none",
                                (values, motion) -> read(values))
                        .asRaw(),
                new DriverCommand(
                                "i2cWrite",
                                List.of(address, register, value),
                                List.of(value),
                                true,
                                "writes to a module; several bytes go with their count before them",
                                this::write)
                        .asRaw());
    }

    private String read(List<Value> values) {
        Question question = Bus.read(address(values.get(0)), octet(values.get(1)), (int)
                values.get(2).number());
        return access.ask(question).numbers().stream().map(String::valueOf).collect(Collectors.joining(", "));
    }

    private String write(List<Value> values, Motion motion) {
        int address = address(values.get(0));
        int register = octet(values.get(1));
        List<Integer> bytes = values.stream().skip(2).map(I2cCommands::octet).toList();
        if (bytes.size() > Bus.MOST_BYTES) {
            throw new BotException("i2cWrite: at most " + Bus.MOST_BYTES + " bytes at once, not " + bytes.size());
        }
        motion.check();
        access.send(
                bytes.size() == 1 ? Bus.write(address, register, bytes.get(0)) : Bus.write(address, register, bytes));
        return "written";
    }

    private static int address(Value given) {
        int address = octet(given);
        if (address % 2 != 0 || address < LOWEST || address > HIGHEST) {
            throw new BotException("address " + given + ": a write address is even, 02 … FC");
        }
        return address;
    }

    private static int octet(Value given) {
        String text = given.toString();
        if (!text.matches("[0-9A-Fa-f]{1,2}")) {
            throw new BotException(text + ": not a byte in hex, 00 … FF (in quotes where a digit comes first: \"0A\")");
        }
        return Integer.parseInt(text, HEX);
    }
}
