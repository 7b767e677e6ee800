package majic.mavlink.message;

import java.util.OptionalDouble;
import majic.mavlink.frame.Payload;

/**
 * Charge and voltage, from a BATTERY_STATUS or a SYS_STATUS. Immutable.
 *
 * @param id of the battery, from 0
 * @param volts empty if unknown
 * @param percent charge left; empty if unknown
 */
public record BatteryReport(int id, OptionalDouble volts, OptionalDouble percent) {
    private static final int UNKNOWN_MV = 0xFFFF;
    private static final int CELLS = 10;

    /** Reads the fields of a BATTERY_STATUS (MAVLink sheet 6). */
    public static BatteryReport ofBattery(Payload payload) {
        int millivolts = 0;
        for (int cell = 0; cell < CELLS; cell++) {
            int one = payload.u16(10 + 2 * cell);
            millivolts += one == UNKNOWN_MV ? 0 : one;
        }
        return new BatteryReport(payload.u8(32), volts(millivolts), percent(payload.i8(35)));
    }

    /** Reads the fields of a SYS_STATUS (MAVLink sheet 6). */
    public static BatteryReport ofSystem(Payload payload) {
        int millivolts = payload.u16(14);
        return new BatteryReport(0, volts(millivolts == UNKNOWN_MV ? 0 : millivolts), percent(payload.i8(30)));
    }

    /** Returns this report with what it leaves out taken from another one. */
    public BatteryReport or(BatteryReport other) {
        return new BatteryReport(
                id, volts.isPresent() ? volts : other.volts, percent.isPresent() ? percent : other.percent);
    }

    private static OptionalDouble volts(int millivolts) {
        return millivolts == 0 ? OptionalDouble.empty() : OptionalDouble.of(millivolts / 1000.0);
    }

    private static OptionalDouble percent(int percent) {
        return percent < 0 ? OptionalDouble.empty() : OptionalDouble.of(percent);
    }
}
