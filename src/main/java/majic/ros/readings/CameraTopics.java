package majic.ros.readings;

import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.regex.Pattern;

/**
 * Orders the topics with compressed pictures. Their type does not show what is in a picture, so their names decide:
 * those of a depth camera, which cannot be shown, are left out, and colour comes before infrared.
 */
final class CameraTopics {
    private static final Pattern DEPTH = Pattern.compile("depth|disparity");
    private static final Pattern COLOUR = Pattern.compile("rgb|colou?r");
    private static final Pattern UNUSUAL = Pattern.compile("[/_](ir|infra\\w*|thermal|mask\\w*|debug\\w*)\\d*([/_]|$)");

    private CameraTopics() {}

    /**
     * Returns those that can be shown, the one that is most likely to be wanted first; of like names the shortest one.
     */
    static List<RosTopic> bestFirst(List<RosTopic> topics) {
        return topics.stream()
                .filter(topic -> !DEPTH.matcher(lowerCase(topic)).find())
                .sorted(Comparator.comparingInt(CameraTopics::rank)
                        .thenComparingInt(topic -> topic.name().split("/").length)
                        .thenComparingInt(topic -> topic.name().length())
                        .thenComparing(RosTopic::name))
                .toList();
    }

    private static int rank(RosTopic topic) {
        if (UNUSUAL.matcher(lowerCase(topic)).find()) {
            return 2;
        }
        return COLOUR.matcher(lowerCase(topic)).find() ? 0 : 1;
    }

    private static String lowerCase(RosTopic topic) {
        return topic.name().toLowerCase(Locale.ROOT);
    }

    /** Returns the camera with a name, with or without the slash in front and the name of the compression behind. */
    static Optional<RosTopic> find(List<RosTopic> cameras, String name) {
        String absolute = name.startsWith("/") ? name : "/" + name;
        return cameras.stream()
                .filter(camera ->
                        camera.name().equals(absolute) || camera.name().equals(absolute + "/compressed"))
                .findFirst();
    }
}
