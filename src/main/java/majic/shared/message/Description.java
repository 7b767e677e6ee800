package majic.shared.message;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.List;
import majic.bot.BotCommand;
import majic.bot.BotProfile;
import majic.bot.Parameter;
import majic.bot.RangeSensor;

/**
 * What a shared robot is and can do. Immutable.
 *
 * @param session the session of the desk that has it
 * @param name the name that the robot was given; empty for none
 * @param kind its type
 * @param introduction what connecting reported: {@code a MobileRobots Pioneer}
 * @param profile its size and speeds
 * @param camera whether it may send pictures
 * @param calibration names of the parameters that are saved with a team
 * @param parameters all that can be read or set
 * @param commands those that only this type of robot has
 * @param sensors those that measure distances along beams
 */
public record Description(
        String session,
        String name,
        Kind kind,
        String introduction,
        BotProfile profile,
        boolean camera,
        List<String> calibration,
        List<Parameter> parameters,
        List<BotCommand> commands,
        List<RangeSensor> sensors) {
    /** A longer description is not used. */
    public static final int MOST_BYTES = 256 * 1024;

    private static final String WHAT = "description";
    private static final int VERSION = 1;

    /** Keeps copies of the lists. */
    public Description {
        calibration = List.copyOf(calibration);
        parameters = List.copyOf(parameters);
        commands = List.copyOf(commands);
        sensors = List.copyOf(sensors);
    }

    /**
     * The type of a robot.
     *
     * @param type its word in addresses: {@code pioneer}
     * @param label its name for users: {@code Pioneer}
     * @param make its maker and name: {@code MobileRobots Pioneer}
     */
    public record Kind(String type, String label, String make) {}

    /**
     * Writes the message.
     *
     * @return JSON in UTF-8
     */
    public byte[] toJson() {
        ObjectNode json = JsonObject.create().put("version", VERSION).put("session", session);
        json.put("name", name).put("type", kind.type).put("label", kind.label).put("make", kind.make);
        json.put("introduction", introduction);
        json.set("profile", DescriptionJson.of(profile));
        json.put("camera", camera);
        ArrayNode names = json.putArray("calibration");
        calibration.forEach(names::add);
        json.set("parameters", DescriptionJson.of(parameters));
        ArrayNode all = json.putArray("commands");
        commands.forEach(command -> all.add(DescriptionJson.of(command)));
        ArrayNode ranging = json.putArray("sensors");
        sensors.forEach(sensor -> ranging.add(DescriptionJson.of(sensor)));
        return JsonObject.bytes(json);
    }

    /**
     * Reads a message.
     *
     * @param payload JSON in UTF-8
     * @return the description
     * @throws UnusableMessageException if it is none
     */
    public static Description parse(byte[] payload) {
        JsonObject json = JsonObject.parse(WHAT, payload, MOST_BYTES);
        String type = json.text("type");
        return new Description(
                json.text("session"),
                json.text("name", ""),
                new Kind(type, json.text("label", type), json.text("make", type)),
                json.text("introduction", "a robot"),
                DescriptionJson.profile(json.object("profile")),
                json.flag("camera", false),
                json.texts("calibration"),
                DescriptionJson.parameters(json, "parameters"),
                json.objects("commands").stream().map(DescriptionJson::command).toList(),
                json.objects("sensors").stream().map(DescriptionJson::sensor).toList());
    }
}
