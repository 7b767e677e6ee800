package majic.hemisson.panel;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.swing.JComponent;
import majic.bot.BotType.ReplayDisplay;
import majic.bot.MajicBot;
import majic.hemisson.line.Identity;
import majic.hemisson.line.Leds;
import majic.hemisson.line.LinkQuality;
import majic.hemisson.line.MotorValues;
import majic.hemisson.readings.Proximity;
import org.jspecify.annotations.Nullable;

/** The panel of a recorded Hemisson, and the texts that it is recorded as. */
public final class HemissonReplay implements ReplayDisplay {
    private static final String LINE = "line";
    private static final String PROXIMITY = "proximity";
    private static final String LIGHT = "light";
    private static final String WHEELS = "wheels";
    private static final String LEDS = "leds";
    private static final String BUZZER = "buzzer";
    private static final String VERSION = "version";
    private static final String TELLS_SPEEDS = "tellsSpeeds";
    private static final String MODE = "switchesAtStart";
    private static final String SWITCHES = "switches";

    private final MajicBot bot;
    private final JComponent panel;
    private volatile HemissonScene scene;

    /** Creates the panel of a robot that is replayed. */
    public HemissonReplay(MajicBot bot) {
        this.bot = bot;
        this.scene = scene(Map.of(), bot);
        this.panel = HemissonPanel.create(bot, () -> scene, Runnable::run);
    }

    /** What is recorded of a scene beside the parameters. */
    public static Map<String, String> texts(HemissonScene scene) {
        HemissonScene.Line line = scene.line();
        LinkQuality quality = line.quality();
        Proximity seen = scene.seen();
        List<Integer> light = scene.light();
        Leds leds = scene.leds();
        Map<String, String> texts = new LinkedHashMap<>();
        texts.put(
                LINE,
                words(
                        Math.round(quality.roundTripMs() * 10) / 10.0,
                        quality.answers(),
                        quality.misses(),
                        quality.repeats(),
                        line.missesAnswers(),
                        Math.round(line.silentS() * 10) / 10.0,
                        line.outOfControl()));
        texts.put(PROXIMITY, seen == null ? "" : words(seen.raw()));
        texts.put(LIGHT, light == null ? "" : words(light));
        texts.put(WHEELS, words(scene.wheels().left(), scene.wheels().right()));
        texts.put(LEDS, words(leds.onOff(), leds.pgm(), leds.left(), leds.right()));
        texts.put(BUZZER, words(scene.buzzing()));
        texts.put(VERSION, scene.identity().version());
        texts.put(TELLS_SPEEDS, words(scene.identity().tellsSpeeds()));
        texts.put(MODE, words(scene.identity().switches()));
        texts.put(SWITCHES, words(scene.switches()));
        return texts;
    }

    private static String words(List<?> values) {
        return words(values.toArray());
    }

    private static String words(Object... values) {
        return Stream.of(values).map(String::valueOf).collect(Collectors.joining(" "));
    }

    private static HemissonScene scene(Map<String, String> texts, MajicBot bot) {
        List<Integer> wheels = numbers(texts, WHEELS);
        String[] leds =
                texts.getOrDefault(LEDS, words(false, false, false, false)).split(" ");
        return new HemissonScene(
                line(texts.getOrDefault(LINE, "0 0 0 0 false 0 false").split(" "), bot),
                eight(texts, PROXIMITY) == null ? null : new Proximity(numbers(texts, PROXIMITY)),
                eight(texts, LIGHT),
                wheels.size() == 2 ? new MotorValues(wheels.get(0), wheels.get(1)) : MotorValues.STILL,
                bot.state(),
                new Leds(isTrue(leds[0]), isTrue(leds[1]), isTrue(leds[2]), isTrue(leds[3])),
                isTrue(texts.getOrDefault(BUZZER, "")),
                new Identity(
                        texts.getOrDefault(VERSION, ""),
                        numbers(texts, MODE),
                        isTrue(texts.getOrDefault(TELLS_SPEEDS, ""))),
                numbers(texts, SWITCHES));
    }

    private static HemissonScene.Line line(String[] words, MajicBot bot) {
        LinkQuality quality = new LinkQuality(
                Double.parseDouble(words[0]),
                Long.parseLong(words[1]),
                Long.parseLong(words[2]),
                Long.parseLong(words[3]),
                Long.MIN_VALUE);
        return new HemissonScene.Line(
                bot.connection(), quality, isTrue(words[4]), Double.parseDouble(words[5]), isTrue(words[6]));
    }

    private static boolean isTrue(String word) {
        return Boolean.parseBoolean(word);
    }

    /** The readings of all sensors; null if they are not known. */
    private static @Nullable List<Integer> eight(Map<String, String> texts, String name) {
        List<Integer> readings = numbers(texts, name);
        return readings.size() == Proximity.SENSORS ? readings : null;
    }

    private static List<Integer> numbers(Map<String, String> texts, String name) {
        return Arrays.stream(texts.getOrDefault(name, "").split(" "))
                .filter(word -> !word.isEmpty())
                .map(Integer::valueOf)
                .toList();
    }

    @Override
    public JComponent component() {
        return panel;
    }

    @Override
    public void reset() {
        scene = scene(Map.of(), bot);
    }

    @Override
    public void show(Map<String, String> state, long nanos) {
        scene = scene(state, bot);
    }
}
