package majicsim.ros.message;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** The message types that the simulated robot and its bridge have, by one version of ROS. Immutable. */
public final class MessageTypes {
    private static final String TABLE = "types.txt";

    private final RosVersion version;
    private final Map<String, MessageType> types = new LinkedHashMap<>();

    private MessageTypes(RosVersion version) {
        this.version = version;
    }

    /**
     * Reads the table of types.
     *
     * @param version whose names and fields the types have
     * @return all types
     */
    public static MessageTypes of(RosVersion version) {
        MessageTypes types = new MessageTypes(version);
        try (InputStream stream = MessageTypes.class.getResourceAsStream(TABLE)) {
            if (stream == null) {
                throw new IllegalStateException("the program's own table " + TABLE + " is missing from its jar");
            }
            BufferedReader lines = new BufferedReader(new InputStreamReader(stream, StandardCharsets.UTF_8));
            lines.lines()
                    .filter(line -> !line.isBlank() && !line.startsWith("#"))
                    .forEach(types::add);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return types;
    }

    /**
     * The version that these are the types of.
     *
     * @return as it was given
     */
    public RosVersion version() {
        return version;
    }

    /**
     * Looks a type up by the name that a client uses. ROS 1 takes two parts alone, ROS 2 two or three (sheet 4).
     *
     * @param name as received
     * @return the type; empty if there is none of this name
     */
    public Optional<MessageType> find(String name) {
        String plain = version == RosVersion.ROS2 ? name.replaceFirst("/msg/", "/") : name;
        return Optional.ofNullable(types.get(plain));
    }

    /**
     * A type that the table is known to have.
     *
     * @param plain package and name
     * @return the type
     * @throws IllegalArgumentException if the table lacks it
     */
    public MessageType get(String plain) {
        MessageType type = types.get(plain);
        if (type == null) {
            throw new IllegalArgumentException("the table of types has no " + plain);
        }
        return type;
    }

    /**
     * One line: the name, a colon, and the fields with commas between them; {@code 1:} before a field that ROS 2 lacks,
     * {@code =} and a number behind one whose default on ROS 2 it is.
     */
    private void add(String line) {
        int colon = line.indexOf(':');
        String plain = line.substring(0, colon).trim();
        List<Field> fields = new ArrayList<>();
        for (String part : line.substring(colon + 1).split(",")) {
            String text = part.trim();
            if (text.startsWith("1:")) {
                text = version == RosVersion.ROS1 ? text.substring(2) : "";
            }
            if (!text.isEmpty()) {
                String[] words = text.split(" ");
                String[] named = words[1].split("=");
                boolean hasDefault = named.length > 1 && version == RosVersion.ROS2;
                double initial = hasDefault ? Double.parseDouble(named[1]) : 0;
                fields.add(new Field(named[0], FieldType.parse(words[0]), initial));
            }
        }
        boolean isOfService = plain.endsWith("Request") || plain.endsWith("Response");
        String name = isOfService ? version.partName(plain) : version.messageName(plain);
        types.put(plain, new MessageType(plain, name, fields));
    }
}
