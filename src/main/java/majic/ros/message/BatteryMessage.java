package majic.ros.message;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.OptionalDouble;

/**
 * The battery: {@code sensor_msgs/BatteryState}, or what a Spot and a Kobuki send in its place. Immutable.
 *
 * @param volts empty if unknown
 * @param percent 0 to 100; empty if unknown
 * @param supply what the message states about charging
 */
public record BatteryMessage(OptionalDouble volts, OptionalDouble percent, Supply supply) {
    /**
     * Larger fractions are percentages: the message defines 0 to 1, but robots send 0 to 100 as well, and 1.1 of a full
     * battery.
     */
    private static final double LARGEST_FRACTION = 1.5;

    private static final double PERCENT = 100;

    /** The field {@code status} of a battery of a Spot (spot_msgs/BatteryState.msg). */
    private static final int SPOT_MISSING = 1;

    private static final int SPOT_CHARGING = 2;
    private static final int SPOT_DISCHARGING = 3;

    /**
     * The lower four bits of the field {@code charger} of a Kobuki; the others are for the kind of charger
     * (SensorState.msg).
     */
    private static final int KOBUKI_CHARGER_STATE = 0x0F;

    private static final int KOBUKI_DISCHARGING = 0;
    private static final int KOBUKI_CHARGED = 2;
    private static final int KOBUKI_CHARGING = 6;
    private static final double KOBUKI_UNIT_V = 0.1;

    /** The field {@code power_supply_status}, in the order of its numbers. */
    public enum Supply {
        /** Not reported. */
        UNKNOWN("unknown"),
        /** The charge rises. */
        CHARGING("charging"),
        /** The robot runs on the battery. */
        DISCHARGING("discharging"),
        /** Connected, but not charging. */
        NOT_CHARGING("not charging"),
        /** Connected, and full. */
        FULL("full");

        private final String words;

        Supply(String words) {
            this.words = words;
        }

        /**
         * Returns how the parameter shows it.
         *
         * @return one or two words
         */
        public String words() {
            return words;
        }
    }

    /**
     * Reads a message.
     *
     * @param message the content of a {@code sensor_msgs/BatteryState}
     * @return the battery
     * @throws UnusableMessage if the message has neither a voltage nor a percentage
     */
    public static BatteryMessage from(JsonNode message) {
        if (!message.has("voltage") && !message.has("percentage")) {
            throw new UnusableMessage("voltage and percentage are absent");
        }
        return new BatteryMessage(
                Fields.optional(message, "voltage"),
                percent(Fields.optional(message, "percentage")),
                supply(Fields.optional(message, "power_supply_status").orElse(0)));
    }

    /**
     * Reads the batteries of a Spot, of which the first one that is there counts.
     *
     * @param message the content of a {@code spot_msgs/BatteryStateArray}
     * @return the battery
     * @throws UnusableMessage if there is no list of batteries, or none of them is in the robot
     */
    public static BatteryMessage spot(JsonNode message) {
        for (JsonNode battery : Fields.list(message, "battery_states")) {
            int status = battery.path("status").asInt(0);
            if (status != SPOT_MISSING) {
                OptionalDouble percent = Fields.optional(battery, "charge_percentage");
                return new BatteryMessage(
                        Fields.optional(battery, "voltage"),
                        percent.isEmpty() ? percent : OptionalDouble.of(clamped(percent.getAsDouble(), PERCENT)),
                        switch (status) {
                            case SPOT_CHARGING -> Supply.CHARGING;
                            case SPOT_DISCHARGING -> Supply.DISCHARGING;
                            default -> Supply.UNKNOWN;
                        });
            }
        }
        throw new UnusableMessage("battery_states has no battery");
    }

    /**
     * Reads the core sensors of a Kobuki, which have no charge.
     *
     * @param message the content of a {@code kobuki_msgs/SensorState} or {@code kobuki_ros_interfaces/SensorState}
     * @return the battery
     * @throws UnusableMessage if the field {@code battery} is missing
     */
    public static BatteryMessage kobuki(JsonNode message) {
        double volts = Fields.number(message, "battery") * KOBUKI_UNIT_V;
        Supply supply = switch (message.path("charger").asInt(-1) & KOBUKI_CHARGER_STATE) {
            case KOBUKI_DISCHARGING -> Supply.DISCHARGING;
            case KOBUKI_CHARGED -> Supply.FULL;
            case KOBUKI_CHARGING -> Supply.CHARGING;
            default -> Supply.UNKNOWN;
        };
        return new BatteryMessage(OptionalDouble.of(volts), OptionalDouble.empty(), supply);
    }

    private static OptionalDouble percent(OptionalDouble sent) {
        if (sent.isEmpty()) {
            return sent;
        }
        double fraction = sent.getAsDouble() > LARGEST_FRACTION ? sent.getAsDouble() / PERCENT : sent.getAsDouble();
        return OptionalDouble.of(PERCENT * clamped(fraction, 1));
    }

    private static double clamped(double value, double most) {
        return Math.max(0, Math.min(most, value));
    }

    private static Supply supply(double number) {
        Supply[] all = Supply.values();
        return number >= 0 && number < all.length ? all[(int) number] : Supply.UNKNOWN;
    }
}
