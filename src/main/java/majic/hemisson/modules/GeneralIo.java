package majic.hemisson.modules;

import majic.bot.Parameter;
import majic.bot.Unit;
import majic.driver.ParameterTable;
import majic.hemisson.readings.RobotReadings;

/** The module with five analogue inputs and twelve digital lines (Hemisson sheet 9). */
final class GeneralIo implements ExtensionModule {
    private static final int ADDRESS = 0xD0;
    private static final int ANALOG = 0x10;
    private static final int ANALOG_INPUTS = 5;
    private static final int[] DIGITAL = {0x20, 0x21, 0x22, 0x23, 0x24, 0x25, 0x26, 0x27, 0x28, 0x29, 0x30, 0x31};

    @Override
    public void describe(ParameterTable table, RobotReadings access) {
        for (int input = 0; input < ANALOG_INPUTS; input++) {
            table.add(
                    Parameter.number("analog" + input, Unit.NONE, "an analogue input, 0 to 255"),
                    access.polledWhileRead(
                            Bus.read(ADDRESS, ANALOG + input, 1),
                            reply -> RobotReadings.count(reply.numbers().get(0))));
        }
        for (int line = 0; line < DIGITAL.length; line++) {
            ModuleNumber.register(ADDRESS, DIGITAL[line])
                    .describeSwitch(
                            table,
                            access,
                            Parameter.onOff("digital" + line, "a digital line; setting makes it an output"));
        }
    }
}
