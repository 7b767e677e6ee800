package majic.ros.message;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.OptionalDouble;

/**
 * The battery ({@code sensor_msgs/BatteryState}). Immutable.
 *
 * @param volts empty if unknown
 * @param percent 0 to 100; empty if unknown
 * @param supply what the message says about charging
 */
public record BatteryMessage(OptionalDouble volts, OptionalDouble percent, Supply supply) {
    /**
     * Larger fractions are percentages: the message defines 0 to 1, but robots send 0 to 100 as well, and 1.1 of a full
     * battery.
     */
    private static final double LARGEST_FRACTION = 1.5;

    private static final double PERCENT = 100;

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

    private static OptionalDouble percent(OptionalDouble sent) {
        if (sent.isEmpty()) {
            return sent;
        }
        double fraction = sent.getAsDouble() > LARGEST_FRACTION ? sent.getAsDouble() / PERCENT : sent.getAsDouble();
        return OptionalDouble.of(PERCENT * Math.max(0, Math.min(1, fraction)));
    }

    private static Supply supply(double number) {
        Supply[] all = Supply.values();
        return number >= 0 && number < all.length ? all[(int) number] : Supply.UNKNOWN;
    }
}
