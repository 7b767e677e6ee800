package majicsim.mavlink;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import majicsim.mavlink.message.Message;
import majicsim.mavlink.message.MessageType;
import org.jspecify.annotations.Nullable;

/**
 * The parameters of a vehicle: some of the true ones with their true defaults. All types are sent as plain floats
 * (sheet 8). They outlast a restart.
 */
final class Parameters {
    /** The index of a parameter that was not asked for by its index. */
    static final int NO_INDEX = 65_535;

    private static final int FLOAT = 9;

    /** Name, type (2 int8, 4 int16, 6 int32, 9 float) and default. */
    private static final String COMMON = """
            SYSID_THISMAV 4 1
            SYSID_MYGCS 4 255
            SYSID_ENFORCE 2 0
            SERIAL0_PROTOCOL 2 2
            SERIAL0_BAUD 6 115
            SERIAL1_PROTOCOL 2 2
            SERIAL1_BAUD 6 57
            SR0_POSITION 4 1
            SR0_EXTRA1 4 1
            AHRS_EKF_TYPE 2 3
            AHRS_ORIENTATION 2 0
            EK3_ENABLE 2 1
            EK3_SRC1_POSXY 2 3
            GPS1_TYPE 2 1
            COMPASS_USE 2 1
            ARMING_CHECK 6 1
            ARMING_REQUIRE 2 1
            BATT_MONITOR 2 4
            BATT_CAPACITY 6 3300
            BATT_LOW_VOLT 9 10.5
            BATT_FS_LOW_ACT 2 0
            BRD_BOOT_DELAY 4 0
            FENCE_ENABLE 2 0
            FLTMODE_CH 2 5
            FS_EKF_THRESH 9 0.8
            FS_GCS_ENABLE 2 0
            FS_GCS_TIMEOUT 9 5
            FS_OPTIONS 6 0
            LOG_DISARMED 2 0
            MIS_TOTAL 4 0
            PRX1_TYPE 2 5
            RNGFND1_TYPE 2 10
            RNGFND1_ORIENT 2 0
            RC_OVERRIDE_TIME 9 3
            RC1_MIN 4 1100
            RC1_TRIM 4 1500
            RC1_MAX 4 1900
            RC1_DZ 4 30
            RC3_MIN 4 1100
            RC3_TRIM 4 1500
            RC3_MAX 4 1900
            RC3_DZ 4 30
            """;

    private static final String ROVER = """
            ATC_ACCEL_MAX 9 1
            ATC_BRAKE 2 1
            ATC_DECEL_MAX 9 0
            ATC_STOP_SPEED 9 0.1
            ATC_STR_ACC_MAX 9 120
            ATC_STR_ANG_P 9 2
            ATC_STR_RAT_MAX 9 120
            CRUISE_SPEED 9 2
            CRUISE_THROTTLE 2 50
            FS_ACTION 2 2
            FS_CRASH_CHECK 2 0
            FS_EKF_ACTION 2 1
            FS_THR_ENABLE 2 1
            FS_THR_VALUE 4 910
            FS_TIMEOUT 9 1.5
            INITIAL_MODE 2 0
            LOIT_RADIUS 9 2
            LOIT_TYPE 2 0
            MODE1 2 0
            MODE_CH 2 8
            RTL_SPEED 9 0
            SPEED_MAX 9 0
            WP_PIVOT_ANGLE 4 60
            WP_PIVOT_RATE 4 60
            WP_RADIUS 9 2
            WP_SPEED 9 2
            """;

    private static final String COPTER = """
            ANGLE_MAX 4 3000
            DISARM_DELAY 2 10
            FLTMODE1 2 7
            FRAME_TYPE 2 0
            FS_CRASH_CHECK 2 1
            FS_EKF_ACTION 2 1
            FS_THR_ENABLE 2 1
            GUID_OPTIONS 6 0
            GUID_TIMEOUT 9 3
            INITIAL_MODE 2 0
            LAND_ALT_LOW 4 1000
            LAND_SPEED 4 50
            LAND_SPEED_HIGH 4 0
            LOIT_SPEED 9 1250
            PILOT_SPEED_DN 4 0
            PILOT_SPEED_UP 4 250
            PILOT_TKOFF_ALT 9 0
            RTL_ALT 6 1500
            RTL_LOIT_TIME 6 5000
            RTL_SPEED 4 0
            WPNAV_ACCEL 9 250
            WPNAV_RADIUS 9 200
            WPNAV_SPEED 9 1000
            WPNAV_SPEED_DN 9 150
            WPNAV_SPEED_UP 9 250
            WP_YAW_BEHAVIOR 2 2
            """;

    private final Map<String, Parameter> byName = new LinkedHashMap<>();

    private record Parameter(int type, float value) {}

    Parameters(VehicleKind kind, int system) {
        COMMON.lines().forEach(this::define);
        (kind == VehicleKind.COPTER ? COPTER : ROVER).lines().forEach(this::define);
        byName.put("FRAME_CLASS", new Parameter(2, kind == VehicleKind.BOAT ? 2 : 1));
        set("SYSID_THISMAV", system);
    }

    private void define(String line) {
        String[] words = line.strip().split(" ");
        byName.put(words[0], new Parameter(Integer.parseInt(words[1]), Float.parseFloat(words[2])));
    }

    /** The value of a parameter that exists. */
    double get(String name) {
        Parameter parameter = byName.get(name);
        if (parameter == null) {
            throw new IllegalArgumentException("the vehicle has no parameter " + name);
        }
        return parameter.value();
    }

    boolean has(String name) {
        return byName.containsKey(name);
    }

    /** Sets a parameter that exists; an integer one to the nearest integer. */
    void set(String name, double value) {
        byName.computeIfPresent(
                name, (key, old) -> new Parameter(old.type(), old.type() == FLOAT ? (float) value : Math.round(value)));
    }

    int count() {
        return byName.size();
    }

    /** The name of the parameter at an index; null if there is none. */
    @Nullable
    String name(int index) {
        return index < 0 || index >= count()
                ? null
                : List.copyOf(byName.keySet()).get(index);
    }

    /** What is sent about a parameter that exists. */
    Message message(String name, int index) {
        Parameter parameter = byName.getOrDefault(name, new Parameter(FLOAT, 0));
        return new Message(MessageType.PARAM_VALUE)
                .with("param_id", name)
                .with("param_value", (double) parameter.value())
                .with("param_type", parameter.type())
                .with("param_count", count())
                .with("param_index", index);
    }
}
