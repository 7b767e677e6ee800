package majic.ros.panel;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.StringJoiner;
import majic.bot.MajicBot;
import majic.bot.Range;
import majic.ros.message.Hazard;

/**
 * The texts that a scene is recorded as, beside the parameters. A recording has a line for each text that changes, so
 * ages are in whole seconds, and a scan has at most {@value #MOST_BEAMS} beams in centimetres.
 */
final class SceneText {
    private static final String ROBOT = "robot";
    private static final String LINK = "link";
    private static final String SCAN = "scan";
    private static final String CONTACTS = "contacts";
    private static final String BATTERY = "battery";
    private static final String TOPICS = "topics";
    private static final String NONE = "-";
    private static final String BETWEEN = ";";
    private static final int MOST_BEAMS = 180;
    private static final double MM_PER_CM = 10;
    private static final double MOST_AGE_S = 99;

    private SceneText() {}

    static Map<String, String> of(RosScene scene) {
        Map<String, String> texts = new LinkedHashMap<>();
        RosScene.Robot robot = scene.robot();
        texts.put(
                ROBOT,
                words(
                        robot.radiusMm(),
                        robot.speedLimits().min(),
                        robot.speedLimits().max(),
                        robot.turnLimits().min(),
                        robot.turnLimits().max(),
                        robot.hasScanner(),
                        robot.hasContacts(),
                        robot.hasCamera()));
        texts.put(
                LINK,
                words(
                        Math.floor(scene.link().silenceS()),
                        Math.round(scene.link().messagesPerSec())));
        texts.put(SCAN, scene.scan().map(SceneText::scan).orElse(""));
        texts.put(CONTACTS, contacts(scene.contacts()));
        texts.put(BATTERY, battery(scene.battery()));
        texts.put(TOPICS, topics(scene.topics()));
        return texts;
    }

    private static String words(Object... values) {
        StringJoiner words = new StringJoiner(" ");
        Arrays.stream(values).forEach(value -> words.add(String.valueOf(value)));
        return words.toString();
    }

    private static String scan(ScanEchoes scan) {
        int step = Math.max(1, (scan.beams() + MOST_BEAMS - 1) / MOST_BEAMS);
        StringJoiner beams = new StringJoiner(" ");
        for (int beam = 0; beam < scan.beams(); beam += step) {
            beams.add(
                    scan.hasEcho(beam)
                            ? Math.round(scan.xMm(beam) / MM_PER_CM) + "," + Math.round(scan.yMm(beam) / MM_PER_CM)
                            : NONE);
        }
        return beams.toString();
    }

    private static String contacts(List<RosScene.Contact> contacts) {
        StringJoiner all = new StringJoiner(BETWEEN);
        contacts.forEach(contact -> all.add(contact.hazard() + " " + contact.place()));
        return all.toString();
    }

    private static String battery(RosScene.Battery battery) {
        return words(
                battery.volts().isPresent()
                        ? String.format(Locale.ROOT, "%.1f", battery.volts().getAsDouble())
                        : NONE,
                battery.percent().isPresent() ? battery.percent().getAsInt() : NONE,
                battery.charging(),
                battery.charger());
    }

    private static String topics(List<RosScene.Topic> topics) {
        StringJoiner all = new StringJoiner(BETWEEN);
        topics.forEach(topic -> all.add(words(
                topic.name(),
                topic.type(),
                Double.isFinite(topic.ageS()) ? (int) Math.min(MOST_AGE_S, topic.ageS()) : NONE)));
        return all.toString();
    }

    /**
     * Reads a scene.
     *
     * @param texts recorded; one that is missing or wrong counts as nothing
     * @param connection state of the connection
     * @param scanNanos when the scan arrived
     * @return empty if the robot is not described
     */
    static Optional<RosScene> parse(Map<String, String> texts, MajicBot.Connection connection, long scanNanos) {
        try {
            String robot = texts.getOrDefault(ROBOT, "");
            return robot.isEmpty()
                    ? Optional.empty()
                    : Optional.of(new RosScene(
                            robot(robot.split(" ")),
                            connection,
                            link(texts.getOrDefault(LINK, "0 0").split(" ")),
                            scan(texts.getOrDefault(SCAN, ""), scanNanos),
                            contactsIn(parts(texts, CONTACTS)),
                            battery(texts.getOrDefault(BATTERY, "").split(" ", 4)),
                            topicsIn(parts(texts, TOPICS))));
        } catch (IllegalArgumentException | ArrayIndexOutOfBoundsException e) {
            return Optional.empty();
        }
    }

    /** Returns the text of the scan, which changes with each scan. */
    static String scanOf(Map<String, String> texts) {
        return texts.getOrDefault(SCAN, "");
    }

    private static List<String> parts(Map<String, String> texts, String name) {
        String all = texts.getOrDefault(name, "");
        return all.isEmpty() ? List.of() : List.of(all.split(BETWEEN));
    }

    private static RosScene.Robot robot(String[] words) {
        return new RosScene.Robot(
                Double.parseDouble(words[0]),
                new Range(Double.parseDouble(words[1]), Double.parseDouble(words[2])),
                new Range(Double.parseDouble(words[3]), Double.parseDouble(words[4])),
                Boolean.parseBoolean(words[5]),
                Boolean.parseBoolean(words[6]),
                Boolean.parseBoolean(words[7]));
    }

    private static RosScene.Link link(String[] words) {
        return new RosScene.Link(Double.parseDouble(words[0]), Double.parseDouble(words[1]));
    }

    private static Optional<ScanEchoes> scan(String text, long atNanos) {
        if (text.isEmpty()) {
            return Optional.empty();
        }
        String[] beams = text.split(" ");
        double[] x = new double[beams.length];
        double[] y = new double[beams.length];
        for (int beam = 0; beam < beams.length; beam++) {
            boolean none = beams[beam].equals(NONE);
            String[] place = beams[beam].split(",");
            x[beam] = none ? Double.NaN : MM_PER_CM * Integer.parseInt(place[0]);
            y[beam] = none ? Double.NaN : MM_PER_CM * Integer.parseInt(place[1]);
        }
        return Optional.of(ScanEchoes.of(x, y, atNanos));
    }

    private static List<RosScene.Contact> contactsIn(List<String> parts) {
        List<RosScene.Contact> contacts = new ArrayList<>();
        for (String part : parts) {
            String[] words = part.split(" ", 2);
            contacts.add(new RosScene.Contact(Hazard.valueOf(words[0]), words[1]));
        }
        return contacts;
    }

    private static RosScene.Battery battery(String[] words) {
        if (words.length < 4) {
            return RosScene.Battery.UNKNOWN;
        }
        return new RosScene.Battery(
                words[0].equals(NONE) ? OptionalDouble.empty() : OptionalDouble.of(Double.parseDouble(words[0])),
                words[1].equals(NONE) ? OptionalInt.empty() : OptionalInt.of(Integer.parseInt(words[1])),
                Boolean.parseBoolean(words[2]),
                words[3]);
    }

    private static List<RosScene.Topic> topicsIn(List<String> parts) {
        List<RosScene.Topic> topics = new ArrayList<>();
        for (String part : parts) {
            String[] words = part.split(" ");
            double age = words[2].equals(NONE) ? Double.POSITIVE_INFINITY : Double.parseDouble(words[2]);
            topics.add(new RosScene.Topic(words[0], words[1], age));
        }
        return topics;
    }
}
