package majic.pioneer.parameters;

import java.util.function.Function;
import majic.bot.Parameter;
import majic.bot.Unit;
import majic.bot.Value;
import majic.driver.AssumedSetting;
import majic.driver.ParameterTable;
import majic.driver.ParameterTheme;
import majic.pioneer.arcos.ArcosCommand;
import majic.pioneer.arcos.Joystick;
import majic.pioneer.arcos.ReportKind;
import majic.pioneer.state.Equipment;

/** The joystick that can be plugged into the robot itself. */
final class JoystickParameters implements ParameterTheme<Equipment> {
    private static final double REST = 512;
    private static final double FULL = 1023;

    private final PioneerAccess access;
    private final AssumedSetting drives = new AssumedSetting();

    JoystickParameters(PioneerAccess access) {
        this.access = access;
    }

    @Override
    public void describe(ParameterTable table, Equipment equipment) {
        axis(table, "joystickX", "sideways, -100 to 100", reported -> deflection(reported.x()));
        axis(table, "joystickY", "ahead and back, -100 to 100", reported -> deflection(reported.y()));
        axis(
                table,
                "joystickThrottle",
                "0 to 100",
                reported -> Value.of(reported.throttle() / FULL * 100, Unit.PERCENT));
        button(table, "joystickButton1", reported -> Value.yesNo(reported.button1()));
        button(table, "joystickButton2", reported -> Value.yesNo(reported.button2()));
        table.add(
                        Parameter.onOff(
                                "joystickDrive", "whether the robot's joystick can drive it too; a stop ends this"),
                        access.assumed(drives))
                .moves((values, motion) -> motion.send(() -> drive(values.get(0).isYes())));
    }

    private void drive(boolean on) {
        access.send(drives, ArcosCommand.JOYDRIVE.packet(on ? 1 : 0), Value.onOff(on));
    }

    /** A stop also ends motions by the joystick. */
    @Override
    public void halt() {
        if (drives.in(access.open()).equals(Value.onOff(true))) {
            drive(false);
        }
    }

    private static Value deflection(int counts) {
        return Value.of((counts - REST) / REST * 100, Unit.PERCENT);
    }

    private void axis(ParameterTable table, String name, String help, Function<Joystick, Value> reader) {
        add(table, Parameter.number(name, Unit.PERCENT, help + "; requested when read"), reader);
    }

    private void button(ParameterTable table, String name, Function<Joystick, Value> reader) {
        add(table, Parameter.yesNo(name, "whether this button is pressed; requested when read"), reader);
    }

    private void add(ParameterTable table, Parameter parameter, Function<Joystick, Value> reader) {
        table.add(
                parameter,
                access.report(ReportKind.JOYSTICK, state -> state.joystick().map(reader)));
    }
}
