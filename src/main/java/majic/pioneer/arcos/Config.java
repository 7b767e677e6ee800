package majic.pioneer.arcos;

import java.util.Collections;
import java.util.EnumMap;
import java.util.EnumSet;
import java.util.Map;
import java.util.Set;

/**
 * The answer to CONFIG: how the robot is built and set (ARCOS sheet 10). Older firmware sends fewer fields, and a
 * library may give access to some fields only; those that did not come are not known, and read as zero or empty.
 * Immutable.
 */
public final class Config {
    /** The type of the packet. */
    public static final int TYPE = 0x20;

    /** Equipment that older firmware does not support: without the field there is none. */
    private static final Set<ConfigField> NEWER = EnumSet.of(ConfigField.CHARGER, ConfigField.HASGYRO);

    private final Map<ConfigField, Object> fields;

    private Config(Map<ConfigField, Object> fields) {
        this.fields = Collections.unmodifiableMap(fields);
    }

    /** Decodes a packet, whatever its length. */
    public static Config decode(Packet packet) {
        FieldReader data = packet.fields();
        Map<ConfigField, Object> fields = new EnumMap<>(ConfigField.class);
        for (ConfigField field : ConfigField.values()) {
            if (data.remaining() > 0 || NEWER.contains(field)) {
                fields.put(field, field.read(data));
            }
        }
        return new Config(fields);
    }

    /**
     * Fields from elsewhere than a packet; all others are not known.
     *
     * @param known numbers as {@code Long}, and texts, as {@link ConfigField} has them
     */
    public static Config of(Map<ConfigField, Object> known) {
        return new Config(new EnumMap<>(known));
    }

    /** Whether the robot has sent this field, or the library gives it. */
    public boolean isKnown(ConfigField field) {
        return fields.containsKey(field);
    }

    /**
     * One field that is a number, in the unit of {@link ConfigField}; the last but one has 32 bits without a sign.
     *
     * @throws IllegalArgumentException if it is text
     */
    public long number(ConfigField field) {
        if (value(field) instanceof Long number) {
            return number;
        }
        throw new IllegalArgumentException(field + " is text");
    }

    /**
     * One field that is text.
     *
     * @throws IllegalArgumentException if it is a number
     */
    public String text(ConfigField field) {
        if (value(field) instanceof String text) {
            return text;
        }
        throw new IllegalArgumentException(field + " is a number");
    }

    private Object value(ConfigField field) {
        return fields.getOrDefault(field, field.missing());
    }

    /** Whether a field about equipment is not zero, or not known. */
    public boolean mayHave(ConfigField field) {
        return !isKnown(field) || number(field) != 0;
    }

    /** Whether the robot never stops by itself, however long no packet comes. */
    public boolean isWithoutWatchdog() {
        return isKnown(ConfigField.WATCHDOG) && number(ConfigField.WATCHDOG) == 0;
    }

    private int small(ConfigField field) {
        return (int) number(field);
    }

    /** What the robot can never exceed; 0 if not reported. */
    public int turnTopDegPerSec() {
        return small(ConfigField.ROTVELTOP);
    }

    /** What the robot can never exceed; 0 if not reported. */
    public int speedTopMmPerSec() {
        return small(ConfigField.TRANSVELTOP);
    }

    /** As set now; 0 if not reported. */
    public int turnMaxDegPerSec() {
        return small(ConfigField.ROTVELMAX);
    }

    /** As set now; 0 if not reported. */
    public int speedMaxMmPerSec() {
        return small(ConfigField.TRANSVELMAX);
    }

    /** How many segments the front bumper has; 0 without one. */
    public int frontBumpers() {
        return small(ConfigField.FRONTBUMPS);
    }

    /** How many segments the rear bumper has; 0 without one. */
    public int rearBumpers() {
        return small(ConfigField.REARBUMPS);
    }

    /** 1 when the serial port's speed can change, 2 when it changes by itself. */
    public int autobaud() {
        return small(ConfigField.AUTOBAUD);
    }

    @Override
    public String toString() {
        return "CONFIG " + fields;
    }
}
