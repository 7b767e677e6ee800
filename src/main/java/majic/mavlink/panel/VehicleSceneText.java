package majic.mavlink.panel;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/**
 * The texts that a scene is recorded as, beside the parameters. A recording has a line for each text that changes, so
 * angles are in whole degrees, echoes in centimetres and at most {@value #MOST_ECHOES}, and messages have no age.
 */
final class VehicleSceneText {
    private static final String ATTITUDE = "attitude";
    private static final String MODES = "modes";
    private static final String ECHOES = "echoes";
    private static final String MESSAGES = "messages";
    private static final String FAILSAFE = "failsafe";
    private static final String BETWEEN = "|";
    private static final int MOST_ECHOES = 72;
    private static final double MM_PER_CM = 10;

    private VehicleSceneText() {}

    static Map<String, String> of(VehicleScene scene) {
        Map<String, String> texts = new LinkedHashMap<>();
        texts.put(ATTITUDE, scene.attitude().map(VehicleSceneText::attitude).orElse(""));
        texts.put(MODES, String.join(" ", scene.modes()));
        texts.put(ECHOES, scene.echoes().map(VehicleSceneText::echoes).orElse(""));
        texts.put(
                MESSAGES,
                scene.messages().stream()
                        .map(message -> message.kind() + " " + message.text().replace(BETWEEN, "/"))
                        .collect(Collectors.joining(BETWEEN)));
        texts.put(FAILSAFE, scene.failsafe().map(String::valueOf).orElse(""));
        return texts;
    }

    private static String attitude(VehicleScene.Attitude attitude) {
        return Math.round(attitude.rollDeg()) + " " + Math.round(attitude.pitchDeg()) + " "
                + Math.round(attitude.compassDeg()) + " " + attitude.current();
    }

    private static String echoes(VehicleScene.Echoes echoes) {
        List<VehicleScene.Echo> points = echoes.points();
        int step = Math.max(1, (points.size() + MOST_ECHOES - 1) / MOST_ECHOES);
        return IntStream.range(0, points.size())
                .filter(index -> index % step == 0)
                .mapToObj(points::get)
                .map(point -> Math.round(point.xMm() / MM_PER_CM) + "," + Math.round(point.yMm() / MM_PER_CM))
                .collect(Collectors.joining(" "));
    }

    /**
     * Reads a scene.
     *
     * @param texts recorded; one that is missing counts as nothing
     * @param echoNanos when the echoes arrived
     * @return empty if a text is wrong, or none was recorded
     */
    static Optional<VehicleScene> parse(Map<String, String> texts, long echoNanos) {
        if (!texts.containsKey(ATTITUDE)) {
            return Optional.empty();
        }
        try {
            return Optional.of(new VehicleScene(
                    attitudeIn(texts.getOrDefault(ATTITUDE, "")),
                    parts(texts, MODES, " "),
                    echoesIn(parts(texts, ECHOES, " "), echoNanos),
                    parts(texts, MESSAGES, "\\|").stream()
                            .map(VehicleSceneText::message)
                            .toList(),
                    failsafeIn(texts.getOrDefault(FAILSAFE, ""))));
        } catch (IllegalArgumentException | ArrayIndexOutOfBoundsException e) {
            return Optional.empty();
        }
    }

    /** Returns the text of the echoes, which changes with them. */
    static String echoesOf(Map<String, String> texts) {
        return texts.getOrDefault(ECHOES, "");
    }

    private static List<String> parts(Map<String, String> texts, String name, String between) {
        String all = texts.getOrDefault(name, "");
        return all.isEmpty() ? List.of() : List.of(all.split(between));
    }

    private static Optional<VehicleScene.Attitude> attitudeIn(String text) {
        if (text.isEmpty()) {
            return Optional.empty();
        }
        String[] words = text.split(" ");
        double[] angles =
                Arrays.stream(words, 0, 3).mapToDouble(Integer::parseInt).toArray();
        return Optional.of(new VehicleScene.Attitude(angles[0], angles[1], angles[2], Boolean.parseBoolean(words[3])));
    }

    /** Of a recording without it, nothing is known. */
    private static Optional<Boolean> failsafeIn(String text) {
        return text.isEmpty() ? Optional.empty() : Optional.of(Boolean.parseBoolean(text));
    }

    private static Optional<VehicleScene.Echoes> echoesIn(List<String> points, long atNanos) {
        return points.isEmpty()
                ? Optional.empty()
                : Optional.of(new VehicleScene.Echoes(
                        points.stream().map(VehicleSceneText::echo).toList(), atNanos));
    }

    private static VehicleScene.Echo echo(String point) {
        String[] place = point.split(",");
        return new VehicleScene.Echo(MM_PER_CM * Integer.parseInt(place[0]), MM_PER_CM * Integer.parseInt(place[1]));
    }

    private static VehicleScene.Message message(String recorded) {
        String[] words = recorded.split(" ", 2);
        return new VehicleScene.Message(VehicleScene.Severity.valueOf(words[0]), words[1], Double.NaN);
    }
}
