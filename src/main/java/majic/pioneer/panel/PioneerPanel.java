package majic.pioneer.panel;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Supplier;
import javax.swing.JComponent;
import majic.bot.BotState;
import majic.bot.MajicBot;
import majic.panel.Banner;
import majic.panel.Dashboard;
import majic.panel.DriveGauges;
import majic.panel.ReadingsPanel;
import majic.panel.RefreshingPanel;
import majic.panel.SidePane;
import majic.panel.map.ZoomableMap;
import majic.pioneer.state.PioneerState;
import majic.pioneer.state.Power;
import majic.text.Texts;
import org.jspecify.annotations.Nullable;

/**
 * Shows one Pioneer: a map with the robot, its sonar cones, echoes and path; gauges, lights and readings. Sends the
 * robot nothing, so that a slip of the mouse has no effect.
 */
public final class PioneerPanel extends RefreshingPanel {
    private static final long serialVersionUID = 1;

    private static final Texts TEXTS = Texts.of(PioneerPanel.class);
    private static final String LONGEST_READING = "-88888.8 mm";
    private static final String LONGEST_DISTANCE = "8888 mm";

    /** None of these parameters sends a request. */
    private static final List<String> READINGS = List.of(
            "distanceFront",
            "distanceBack",
            "distanceLeft",
            "distanceRight",
            "x",
            "y",
            "heading",
            "packetRate",
            "model",
            "robotName",
            "firmware");

    private final transient MajicBot bot;
    private final transient Supplier<Optional<PioneerScene>> scenes;
    private final transient PioneerDrawing drawing = new PioneerDrawing();
    private final ZoomableMap map = new ZoomableMap(drawing);
    private final DriveGauges gauges = new DriveGauges();
    private final transient PioneerLights lights = new PioneerLights();
    private final ReadingsPanel<MajicBot> readings = ReadingsPanel.ofParameters(LONGEST_READING, READINGS)
            .labelled(TEXTS::get)
            .paired(4, LONGEST_DISTANCE);

    private transient @Nullable PioneerScene shown;
    private final Banner banner = new Banner();

    private PioneerPanel(MajicBot bot, Supplier<Optional<PioneerScene>> scenes) {
        super(bot);
        this.bot = bot;
        this.scenes = scenes;
        map.getAccessibleContext().setAccessibleName(TEXTS.get("map"));
        add(map);
        add(gauges);
        add(lights.panel());
        add(readings);
        add(banner);
        List<SidePane> asides = List.of(SidePane.of(gauges), SidePane.of(lights.panel()));
        setLayout(new Dashboard(map, 0, asides, readings).under(banner));
    }

    /**
     * Makes the panel; on the event dispatch thread.
     *
     * @param scenes gives what to show, on any thread; empty before the first report of the robot
     */
    public static JComponent create(MajicBot bot, Supplier<Optional<PioneerScene>> scenes) {
        PioneerPanel panel = new PioneerPanel(bot, scenes);
        panel.refreshIfChanged();
        return panel;
    }

    @Override
    protected void stateReceived(BotState state) {
        scenes.get().ifPresent(scene -> drawing.record(scene.model(), scene.state()));
    }

    @Override
    protected void refresh() {
        readings.show(bot, bot.isConnected());
        banner.show(staleness(), false);
        scenes.get().or(this::old).ifPresentOrElse(this::show, () -> lights.show(bot.connection()));
    }

    /** Returns what was shown last, while a new connection has reported nothing yet. */
    private Optional<PioneerScene> old() {
        return Optional.ofNullable(shown).map(scene -> scene.before(bot.connection()));
    }

    private void show(PioneerScene scene) {
        shown = scene;
        drawing.show(scene);
        map.repaint();
        PioneerState state = scene.state();
        gauges.setCurrent(scene.isConnected() && isCurrent());
        gauges.showMotion(state.speedMmPerSec(), scene.speedLimits(), state.turnRateDegPerSec(), scene.turnLimits());
        Power power = state.power();
        gauges.showBattery(
                OptionalDouble.of(power.volts()),
                power.percent(),
                power.charging().isCharging(),
                power.charging().words());
        lights.show(scene);
    }
}
