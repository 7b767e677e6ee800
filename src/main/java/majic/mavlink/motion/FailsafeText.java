package majic.mavlink.motion;

import java.util.Optional;
import majic.mavlink.session.VehicleClass;
import majic.mavlink.session.VehicleSession;

/** What a vehicle does when MAJIC ends without a stop, by the parameters of its autopilot (MAVLink sheet 9). */
public final class FailsafeText {
    private FailsafeText() {}

    /** Returns what it does, as a part of a sentence. */
    public static String of(VehicleSession session) {
        if (session.modes().isPx4()) {
            return "NAV_DLL_ACT and COM_DL_LOSS_T of its autopilot say what";
        }
        if (!session.modes().isArduPilot()) {
            return "MAJIC does not know the failsafes of its autopilot";
        }
        Optional<Double> enabled = session.parameters().known("FS_GCS_ENABLE");
        if (enabled.isEmpty()) {
            return "its parameter FS_GCS_ENABLE, which was not read, says what";
        }
        if (enabled.get() == 0) {
            return "it goes on as if nothing had happened, since FS_GCS_ENABLE is 0";
        }
        return session.vehicle() == VehicleClass.ROVER || session.vehicle() == VehicleClass.BOAT
                ? action(session) + " after some seconds, by FS_GCS_ENABLE and FS_ACTION"
                : "it does what FS_GCS_ENABLE " + Math.round(enabled.get()) + " says";
    }

    private static String action(VehicleSession session) {
        int action =
                session.parameters().known("FS_ACTION").map(Double::intValue).orElse(-1);
        return switch (action) {
            case 0 -> "it goes on, since FS_ACTION is 0,";
            case 1 -> "it returns to its home position";
            case 2 -> "it goes to HOLD";
            default -> "it does what FS_ACTION says";
        };
    }

    /** Whether the vehicle goes on when MAJIC ends without a stop, by what was read. */
    public static boolean goesOn(VehicleSession session) {
        return session.modes().isArduPilot()
                && session.parameters()
                        .known("FS_GCS_ENABLE")
                        .filter(enabled -> enabled == 0)
                        .isPresent();
    }
}
