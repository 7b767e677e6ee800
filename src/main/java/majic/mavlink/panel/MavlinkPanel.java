package majic.mavlink.panel;

import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import javax.swing.JComponent;
import majic.bot.BotState;
import majic.bot.MajicBot;
import majic.panel.Banner;
import majic.panel.Dashboard;
import majic.panel.ReadingsPanel;
import majic.panel.RefreshingPanel;
import majic.panel.SidePane;
import majic.panel.map.ZoomableMap;
import majic.text.Texts;
import org.jspecify.annotations.Nullable;

/**
 * Shows one MAVLink vehicle: a map with its way and echoes, the newest texts of its autopilot, its attitude, height,
 * speeds and battery, lights, readings, and buttons for its mode and its own commands. Only these buttons send anything
 * to the vehicle.
 */
public final class MavlinkPanel extends RefreshingPanel {
    private static final long serialVersionUID = 1;
    private static final Texts TEXTS = Texts.of(MavlinkPanel.class);
    private static final String LONGEST_READING = "-88888.8888888°";
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
            "roll",
            "pitch",
            "latitude",
            "longitude",
            "model");

    private final transient MajicBot bot;
    private final transient Supplier<Optional<VehicleScene>> scenes;
    private final transient VehicleDrawing drawing = new VehicleDrawing();
    private final ZoomableMap map = new ZoomableMap(drawing);
    private final AutopilotMessages messages = new AutopilotMessages();
    private final FlightPanel flight = new FlightPanel();
    private final ReadingsPanel<MajicBot> readings = ReadingsPanel.ofParameters(LONGEST_READING, READINGS)
            .labelled(TEXTS::get)
            .paired(4, LONGEST_DISTANCE);

    private final Banner banner = new Banner();
    private transient @Nullable VehicleScene shown;

    private MavlinkPanel(MajicBot bot, Supplier<Optional<VehicleScene>> scenes) {
        super(bot);
        this.bot = bot;
        this.scenes = scenes;
        map.getAccessibleContext().setAccessibleName(TEXTS.get("map"));
        MapWithMessages view = new MapWithMessages(map, messages);
        add(view);
        add(flight);
        add(readings);
        add(banner);
        setLayout(new Dashboard(view, 0, List.of(SidePane.folding(flight)), readings).under(banner));
    }

    /**
     * Makes the panel; on the event dispatch thread.
     *
     * @param scenes gives what to show beside the parameters, on any thread; empty before the first connection
     */
    public static JComponent create(MajicBot bot, Supplier<Optional<VehicleScene>> scenes) {
        return of(bot, scenes);
    }

    /** As {@link #create}, which does not name this class: a driver loads it only where there is a window. */
    static MavlinkPanel of(MajicBot bot, Supplier<Optional<VehicleScene>> scenes) {
        MavlinkPanel panel = new MavlinkPanel(bot, scenes);
        panel.refreshIfChanged();
        return panel;
    }

    @Override
    protected void stateReceived(BotState state) {
        drawing.record(state.pose(), scenes.get().flatMap(VehicleScene::echoes));
    }

    @Override
    protected void refresh() {
        readings.show(bot, bot.isConnected());
        banner.show(staleness(), false);
        Optional<VehicleScene> scene = scenes.get().or(this::old);
        flight.show(bot, scene);
        scene.ifPresent(this::show);
    }

    /** Returns what was shown last, while a new connection has reported nothing yet. */
    private Optional<VehicleScene> old() {
        return Optional.ofNullable(shown).map(VehicleScene::before);
    }

    private void show(VehicleScene scene) {
        shown = scene;
        messages.show(scene.messages(), bot.isConnected());
        if (!bot.state().equals(BotState.UNKNOWN)) {
            drawing.show(new VehicleDrawing.PlacedVehicle(
                    bot.state().pose(), bot.profile().bodyMm(), bot.isConnected()));
        }
        map.repaint();
    }
}
