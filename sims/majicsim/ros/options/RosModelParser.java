package majicsim.ros.options;

import java.util.Locale;
import majicsim.ros.message.RosVersion;

/** Parses the words of a model, one after the other. */
final class RosModelParser {
    static final String KNOWN =
            "1 or 2, then +stamped +timeout=0.5 +timeout=none +unblocked +nonavigation +namespace=tb3 +robots=2 +camera"
                    + " +auth=SECRET +server=tb3";

    private RosModelParser() {}

    static RosOptions parse(String model) {
        String[] words = model.split("\\+", -1);
        RosOptions options = RosOptions.of(version(words[0]));
        for (int i = 1; i < words.length; i++) {
            options = with(options, words[i]);
        }
        return options;
    }

    private static RosVersion version(String word) {
        return switch (word) {
            case "1" -> RosVersion.ROS1;
            case "2" -> RosVersion.ROS2;
            default -> throw unknown(word);
        };
    }

    private static RosOptions with(RosOptions options, String text) {
        int equals = text.indexOf('=');
        String word = (equals < 0 ? text : text.substring(0, equals)).toLowerCase(Locale.ROOT);
        if (equals >= 0) {
            return with(options, word, text.substring(equals + 1));
        }
        return switch (word) {
            case "stamped" -> options.stamped();
            case "unblocked" -> options.unblocked();
            case "camera" -> options.withCamera();
            case "nonavigation" -> options.withoutNavigation();
            default -> throw unknown(text);
        };
    }

    private static RosOptions with(RosOptions options, String word, String value) {
        return switch (word) {
            case "timeout" -> options.withTimeout(seconds(value));
            case "namespace" -> options.withNamespace(value);
            case "robots" -> options.withRobots(count(value));
            case "server" -> options.withServerNamespace(value);
            case "auth" -> options.withSecret(value);
            default -> throw unknown(word);
        };
    }

    private static double seconds(String value) {
        try {
            return value.equalsIgnoreCase("none") ? 0 : Double.parseDouble(value);
        } catch (NumberFormatException e) {
            throw new IllegalArgumentException("timeout must be seconds or none, not '" + value + "'", e);
        }
    }

    private static int count(String value) {
        try {
            return Integer.parseInt(value);
        } catch (NumberFormatException e) {
            throw new IllegalArgumentException("robots must be a number, not '" + value + "'", e);
        }
    }

    private static IllegalArgumentException unknown(String word) {
        return new IllegalArgumentException("there is no '" + word + "' for a ROS robot; known are " + KNOWN);
    }
}
