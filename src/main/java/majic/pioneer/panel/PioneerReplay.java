package majic.pioneer.panel;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.swing.JComponent;
import majic.bot.BotType.ReplayDisplay;
import majic.bot.MajicBot;
import majic.bot.Range;
import majic.pioneer.arcos.PacketCounts;
import majic.pioneer.arcos.Sip;
import majic.pioneer.state.Bumpers;
import majic.pioneer.state.Hull;
import majic.pioneer.state.Model;
import majic.pioneer.state.Models;
import majic.pioneer.state.PioneerState;
import majic.pioneer.state.Scaling;
import majic.pioneer.state.SonarDisc;
import majic.pioneer.state.StateTracker;
import org.jspecify.annotations.Nullable;

/** The panel of a recorded Pioneer, and the texts that it is recorded as: above all its SIPs. */
public final class PioneerReplay implements ReplayDisplay {
    private static final String MODEL = "model";
    private static final String SIP = "sip";
    private static final String BUMPERS = "bumpers";
    private static final String PACKET_RATE = "rate";
    private static final String PACKETS = "packets";
    private static final String LIMITS = "limits";
    private static final String SCALE = "scale";
    private static final String HULL = "hull";
    private static final String SONARS = "sonars";
    private static final long NANOS_PER_MS = 1_000_000;

    private final MajicBot bot;
    private final JComponent panel;
    private @Nullable StateTracker tracker;
    private String lastSip = "";
    private volatile @Nullable PioneerScene scene;

    /** Creates the panel of a robot that is replayed. */
    public PioneerReplay(MajicBot bot) {
        this.bot = bot;
        this.panel = PioneerPanel.create(bot, () -> Optional.ofNullable(scene));
    }

    /** What is recorded of a scene beside the parameters; the time makes a difference between equal SIPs. */
    public static Map<String, String> texts(PioneerScene scene) {
        PioneerState state = scene.state();
        PacketCounts packets = scene.packets();
        Map<String, String> texts = new LinkedHashMap<>();
        texts.put(MODEL, scene.model().subclass());
        texts.putAll(differences(scene.model()));
        texts.put(SIP, state.atNanos() / NANOS_PER_MS + " " + state.sip().text());
        texts.put(
                BUMPERS, words(scene.bumpers().frontSegments(), scene.bumpers().rearSegments()));
        texts.put(PACKET_RATE, words(scene.packetRate()));
        texts.put(PACKETS, words(packets.packets(), packets.damagedPackets(), packets.skippedBytes()));
        texts.put(
                LIMITS,
                words(
                        scene.speedLimits().min(),
                        scene.speedLimits().max(),
                        scene.turnLimits().min(),
                        scene.turnLimits().max()));
        return texts;
    }

    /** What a robot's own parameter file, or its CONFIG packet, has changed in its model. */
    private static Map<String, String> differences(Model model) {
        if (model.equals(Models.of(model.subclass()))) {
            return Map.of();
        }
        Scaling scale = model.scaling();
        Hull hull = model.hull();
        return Map.of(
                SCALE,
                words(
                        scale.mmPerCount(),
                        scale.degPerCount(),
                        scale.mmPerSecPerCount(),
                        scale.mmPerRangeCount(),
                        scale.radPerMm()),
                HULL,
                words(hull.frontMm(), hull.rearMm(), hull.halfWidthMm()),
                SONARS,
                model.discs().stream()
                        .map(disc -> words(disc.number(), disc.xMm(), disc.yMm(), disc.axisDeg()))
                        .collect(Collectors.joining(" ")));
    }

    /** The model of a recorded robot. */
    static Model model(Map<String, String> texts) {
        Model usual = Models.of(texts.getOrDefault(MODEL, ""));
        if (!texts.containsKey(SCALE)) {
            return usual;
        }
        double[] scale = numbers(texts, SCALE, 5);
        double[] hull = numbers(texts, HULL, 3);
        return usual.with(
                new Hull(hull[0], hull[1], hull[2]),
                discs(texts),
                new Scaling(scale[0], scale[1], scale[2], scale[3], scale[4]));
    }

    private static List<SonarDisc> discs(Map<String, String> texts) {
        String[] words = texts.getOrDefault(SONARS, "").split(" ");
        double[] numbers = numbers(texts, SONARS, words.length);
        return IntStream.range(0, numbers.length / 4)
                .map(disc -> 4 * disc)
                .mapToObj(at -> new SonarDisc((int) numbers[at], numbers[at + 1], numbers[at + 2], numbers[at + 3]))
                .toList();
    }

    private static String words(Number... numbers) {
        return Stream.of(numbers).map(String::valueOf).collect(Collectors.joining(" "));
    }

    @Override
    public JComponent component() {
        return panel;
    }

    @Override
    public void reset() {
        tracker = null;
        scene = null;
        lastSip = "";
    }

    @Override
    public void show(Map<String, String> texts, long nanos) {
        String sip = texts.get(SIP);
        PioneerScene before = scene;
        if (sip == null) {
            return;
        }
        Model model = model(texts);
        PioneerState state = before == null || !sip.equals(lastSip) ? track(model, sip, nanos) : before.state();
        lastSip = sip;
        scene = scene(model, state, texts);
    }

    private PioneerState track(Model model, String sip, long nanos) {
        StateTracker following = tracker;
        if (following == null) {
            following = new StateTracker(model, bot.state().pose());
            tracker = following;
        }
        return following.track(Sip.parse(sip.substring(sip.indexOf(' ') + 1)), nanos);
    }

    private PioneerScene scene(Model model, PioneerState state, Map<String, String> texts) {
        double[] bumpers = numbers(texts, BUMPERS, 2);
        double[] packets = numbers(texts, PACKETS, 3);
        double[] limits = numbers(texts, LIMITS, 4);
        return new PioneerScene(
                model,
                state,
                Optional.empty(),
                new Bumpers((int) bumpers[0], (int) bumpers[1]),
                bot.connection(),
                bot.get("age").number(),
                numbers(texts, PACKET_RATE, 1)[0],
                new PacketCounts((long) packets[0], (long) packets[1], (long) packets[2]),
                new Range(limits[0], limits[1]),
                new Range(limits[2], limits[3]));
    }

    private static double[] numbers(Map<String, String> texts, String name, int count) {
        double[] numbers = new double[count];
        String[] words = texts.getOrDefault(name, "").split(" ");
        for (int index = 0; index < Math.min(count, words.length) && !words[index].isEmpty(); index++) {
            numbers[index] = Double.parseDouble(words[index]);
        }
        return numbers;
    }
}
