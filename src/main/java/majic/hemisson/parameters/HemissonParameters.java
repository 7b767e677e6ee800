package majic.hemisson.parameters;

import majic.bot.ParameterTable;
import majic.hemisson.modules.Modules;
import majic.hemisson.motion.SpeedCalibration;
import majic.hemisson.readings.RobotReadings;

/**
 * The parameters of every Hemisson; {@link Modules} adds those of its modules.
 *
 * @param access reads from the robot and sends to it
 * @param lamps the LEDs and the buzzer
 * @param pins the pins of the extension connector
 * @param calibration what the motor values mean
 * @param robot what the driver has found out about it
 */
public record HemissonParameters(
        RobotReadings access,
        LedsAndBuzzer lamps,
        Pins pins,
        SpeedCalibration calibration,
        RobotParameters.Source robot) {
    /** Adds all of them. */
    public void describe(ParameterTable table) {
        new InfraredParameters(table, access).describe();
        new LedAndBuzzerParameters(table, lamps).describe();
        new MotorParameters(table, access, calibration).describe();
        new RobotParameters(table, access, robot).describe();
        new PinParameters(table, access, pins).describe();
    }
}
