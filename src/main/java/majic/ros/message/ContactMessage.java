package majic.ros.message;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.List;

/**
 * One message about one or several contacts of a base, from which the state of each contact follows until the next
 * message about it. Immutable.
 *
 * @param contacts each with its present state
 */
public record ContactMessage(List<Contact> contacts) {
    /** The numbers in events of a Kobuki. */
    private static final List<String> SIDES = List.of("left", "centre", "right");

    private static final List<String> WHEELS = List.of("left", "right");

    /** The bits in its core sensors, the lowest one first, are in the opposite order (SensorState.msg). */
    private static final List<String> BITS = List.of("right", "centre", "left");

    private static final List<String> WHEEL_BITS = List.of("right", "left");

    /** Keeps a copy. */
    public ContactMessage {
        contacts = List.copyOf(contacts);
    }

    /**
     * A contact.
     *
     * @param hazard what it means if it is active
     * @param place where it is: {@code left}, {@code front} …
     * @param active whether it is pressed, is above a step, or hangs in the air
     */
    public record Contact(Hazard hazard, String place, boolean active) {}

    /**
     * Reads an event of a Kobuki, which is sent only when a contact changes.
     *
     * @param message the content of a {@code kobuki_msgs/BumperEvent}, {@code CliffEvent} or {@code WheelDropEvent}
     * @return the one contact
     * @throws UnusableMessage if it is none of these
     */
    public static ContactMessage kobuki(JsonNode message) {
        boolean active = Fields.number(message, "state") == 1;
        if (message.has("bumper")) {
            return one(Hazard.BUMP, side(message, "bumper", SIDES), active);
        }
        if (message.has("sensor")) {
            return one(Hazard.CLIFF, side(message, "sensor", SIDES), active);
        }
        return one(Hazard.WHEEL_DROP, side(message, "wheel", WHEELS), active);
    }

    /**
     * Reads the state of a TurtleBot3.
     *
     * @param message the content of a {@code turtlebot3_msgs/SensorState}
     * @return its two bumpers
     * @throws UnusableMessage if there is no field {@code bumper}
     */
    public static ContactMessage turtleBot3(JsonNode message) {
        int bits = (int) Fields.number(message, "bumper");
        List<Contact> contacts = new ArrayList<>();
        contacts.add(new Contact(Hazard.BUMP, "front", (bits & 1) != 0));
        contacts.add(new Contact(Hazard.BUMP, "back", (bits & 2) != 0));
        return new ContactMessage(contacts);
    }

    /**
     * Reads the core sensors of a Kobuki, which are sent all the time.
     *
     * @param message the content of a {@code kobuki_msgs/SensorState} or {@code kobuki_ros_interfaces/SensorState}
     * @return its bumpers, cliff sensors and wheels
     * @throws UnusableMessage if one of the fields {@code bumper}, {@code cliff} and {@code wheel_drop} is missing
     */
    public static ContactMessage kobukiCore(JsonNode message) {
        List<Contact> contacts = new ArrayList<>();
        addBits(contacts, Hazard.BUMP, message, "bumper", BITS);
        addBits(contacts, Hazard.CLIFF, message, "cliff", BITS);
        addBits(contacts, Hazard.WHEEL_DROP, message, "wheel_drop", WHEEL_BITS);
        return new ContactMessage(contacts);
    }

    private static void addBits(
            List<Contact> contacts, Hazard hazard, JsonNode message, String field, List<String> places) {
        int bits = (int) Fields.number(message, field);
        for (int bit = 0; bit < places.size(); bit++) {
            contacts.add(new Contact(hazard, places.get(bit), (bits & 1 << bit) != 0));
        }
    }

    private static ContactMessage one(Hazard hazard, String place, boolean active) {
        return new ContactMessage(List.of(new Contact(hazard, place, active)));
    }

    private static String side(JsonNode message, String field, List<String> sides) {
        int number = (int) Fields.number(message, field);
        return number >= 0 && number < sides.size() ? sides.get(number) : String.valueOf(number);
    }
}
