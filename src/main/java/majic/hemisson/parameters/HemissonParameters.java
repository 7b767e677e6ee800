package majic.hemisson.parameters;

import java.util.List;
import java.util.function.Supplier;
import majic.driver.ParameterTable;
import majic.driver.ParameterTheme;
import majic.hemisson.line.Identity;
import majic.hemisson.line.LinkQuality;
import majic.hemisson.modules.Modules;
import majic.hemisson.motion.SpeedCalibration;
import majic.hemisson.readings.RobotReadings;

/** The parameters of a Hemisson besides those that every robot has, theme by theme; those of its modules come last. */
public final class HemissonParameters {
    /** The names of the parameters that are measured once for each robot. */
    public static final List<String> CALIBRATION = List.of(MotorParameters.TABLE, "wheelDistance", "trim");

    private final ParameterTable table;
    private final List<ParameterTheme<Modules>> themes;

    /**
     * Describes nothing yet.
     *
     * @param access reads from the robot and sends to it
     * @param leds the LEDs and the buzzer
     * @param pins the pins of the extension connector
     * @param calibration the speeds of the motor values
     * @param robot the robot that answered at connecting
     * @param quality how well it answers
     */
    public HemissonParameters(
            ParameterTable table,
            RobotReadings access,
            LedsAndBuzzer leds,
            Pins pins,
            SpeedCalibration calibration,
            Supplier<Identity> robot,
            Supplier<LinkQuality> quality) {
        this.table = table;
        this.themes = List.of(
                new InfraredParameters(access),
                new LedAndBuzzerParameters(leds),
                new MotorParameters(access, calibration),
                new RobotParameters(access, robot, quality),
                new PinParameters(access, pins),
                (fresh, modules) -> modules.describe(fresh, access));
    }

    /** Describes what a robot with these modules has. */
    public void describe(Modules modules) {
        table.renew(fresh -> themes.forEach(theme -> theme.describe(fresh, modules)));
    }
}
