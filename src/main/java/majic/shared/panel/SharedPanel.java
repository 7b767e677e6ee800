package majic.shared.panel;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.Set;
import java.util.function.Supplier;
import javax.swing.JComponent;
import majic.bot.BotException;
import majic.bot.BotState;
import majic.bot.MajicBot;
import majic.bot.Parameter;
import majic.bot.Value;
import majic.panel.Banner;
import majic.panel.Dashboard;
import majic.panel.DriveGauges;
import majic.panel.ReadingsPanel;
import majic.panel.RefreshingPanel;
import majic.panel.SidePane;
import majic.panel.map.ZoomableMap;
import majic.text.Texts;
import majic.time.WaitPolicy;

/**
 * Shows one shared robot of any type: a map with its path, gauges, its holder, the delay, the camera, and what it
 * measures. Sends the robot nothing but requests for pictures.
 */
public final class SharedPanel extends RefreshingPanel {
    private static final long serialVersionUID = 1;

    private static final Texts TEXTS = Texts.of(SharedPanel.class);
    private static final String LONGEST_READING = "8888.8 mm/s";
    private static final int MOST_READINGS = 24;

    /** Shown by gauges, lights and the map. */
    private static final Set<String> ELSEWHERE = Set.of(
            "speed", "turnRate", "moving", "age", "body", "voltage", "battery", "desk", "holder", "delay", "pose");

    private static final Set<String> FIRST = Set.of("x", "y", "heading", "bumped");

    private final transient MajicBot bot;
    private final transient Supplier<SharedScene> scenes;
    private final transient SharedDrawing drawing;
    private final ZoomableMap map;
    private final transient SharedCamera camera;
    private final DriveGauges gauges = new DriveGauges();
    private final transient SharedLights lights = new SharedLights();
    private final ReadingsPanel<MajicBot> readings;
    private final Banner banner = new Banner();
    private boolean hasCamera;

    private SharedPanel(MajicBot bot, Supplier<SharedScene> scenes, Supplier<byte[]> pictures) {
        super(bot);
        this.bot = bot;
        this.scenes = scenes;
        this.drawing = new SharedDrawing(!bot.profile().estimates());
        this.map = new ZoomableMap(drawing);
        this.camera = new SharedCamera(bot, pictures);
        this.readings =
                ReadingsPanel.ofParameters(LONGEST_READING, measured(bot)).labelled(SharedLabels::of);
        map.getAccessibleContext().setAccessibleName(TEXTS.get("map"));
        add(map);
        add(gauges);
        add(lights.panel());
        add(readings);
        add(banner);
        arrange();
    }

    /**
     * Makes the panel; on the event dispatch thread.
     *
     * @param scenes gives what to show beside the parameters, on any thread
     * @param pictures requests a picture of the camera, a JPEG file, while it is visible; blocks, not on the event
     *     dispatch thread, and throws a {@link BotException} with the reason if there is none
     */
    public static JComponent create(MajicBot bot, Supplier<SharedScene> scenes, Supplier<byte[]> pictures) {
        return of(bot, scenes, pictures);
    }

    /** As {@link #create}, which does not name this class: a driver loads it only where there is a window. */
    static SharedPanel of(MajicBot bot, Supplier<SharedScene> scenes, Supplier<byte[]> pictures) {
        SharedPanel panel = new SharedPanel(bot, scenes, pictures);
        panel.refreshIfChanged();
        return panel;
    }

    /** What the robot measures: what can be read but not set, and is not a list or a text. */
    private static List<String> measured(MajicBot bot) {
        return bot.parameters().stream()
                .filter(parameter -> parameter.readable() && !parameter.writable())
                .filter(parameter -> parameter.kind() != Parameter.Kind.LIST && parameter.kind() != Parameter.Kind.TEXT)
                .map(Parameter::name)
                .filter(name -> !ELSEWHERE.contains(name))
                .sorted(Comparator.comparingInt(SharedPanel::rank))
                .limit(MOST_READINGS)
                .toList();
    }

    /** What users look at most comes first, because a small panel has no room for everything. */
    private static int rank(String parameter) {
        return parameter.startsWith("distance") ? 0 : FIRST.contains(parameter) ? 1 : 2;
    }

    /** Places everything; a robot without a camera leaves its space to the others. */
    private void arrange() {
        List<SidePane> asides = new ArrayList<>();
        if (hasCamera) {
            add(camera.view());
            asides.add(SidePane.shaped(camera.view()));
        }
        asides.add(SidePane.of(gauges));
        asides.add(SidePane.of(lights.panel()));
        setLayout(new Dashboard(map, 0, asides, readings).under(banner));
        revalidate();
        repaint();
    }

    @Override
    protected void stateReceived(BotState state) {
        drawing.poseReported(state.pose());
    }

    /** Reads only what has been reported: a request would block the event dispatch thread. */
    @Override
    protected void refresh() {
        WaitPolicy.observing(this::showScene);
    }

    private void showScene() {
        boolean current = bot.isConnected();
        SharedScene scene = scenes.get();
        if (scene.camera() && !hasCamera) {
            hasCamera = true;
            arrange();
        }
        readings.show(bot, current);
        banner.show(staleness(), false);
        BotState state = bot.state();
        drawing.show(state.pose(), bot.profile().bodyMm(), current);
        map.repaint();
        gauges.setCurrent(current);
        gauges.showMotion(
                state.speedMmPerSec(),
                bot.profile().speed(),
                state.turnRateDegPerSec(),
                bot.profile().turn());
        if (current) {
            showBattery();
        }
        camera.view().setCurrent(current);
        lights.show(bot, scene);
    }

    private void showBattery() {
        OptionalDouble volts = number("voltage");
        OptionalDouble percent = number("battery");
        gauges.showBattery(
                volts,
                percent.isPresent() ? OptionalInt.of((int) Math.round(percent.getAsDouble())) : OptionalInt.empty(),
                false,
                "");
    }

    private OptionalDouble number(String parameter) {
        try {
            return bot.get(parameter) instanceof Value.Number number
                    ? OptionalDouble.of(number.amount())
                    : OptionalDouble.empty();
        } catch (BotException e) {
            return OptionalDouble.empty();
        }
    }

    /** Shows that no picture was recorded at this time; on any thread. */
    void missPicture() {
        camera.miss(TEXTS.get("camera.notRecorded"));
    }

    /** Shows a recorded picture; not on the event dispatch thread. */
    void showPicture(byte[] jpeg) {
        camera.show(jpeg);
    }
}
