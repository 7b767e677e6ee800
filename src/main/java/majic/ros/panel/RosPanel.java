package majic.ros.panel;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
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
import majic.team.Member;
import majic.text.Texts;
import org.jspecify.annotations.Nullable;

/**
 * Shows one ROS robot: a map with its scan, echoes and path; the camera, if it has one; gauges, lights, readings and
 * topics. Sends the robot nothing, so that a slip of the mouse has no effect.
 */
public final class RosPanel extends RefreshingPanel {
    private static final long serialVersionUID = 1;

    private static final Texts TEXTS = Texts.of(RosPanel.class);
    private static final String LONGEST_READING = "TurtleBot3 Waffle (ROS 2)";
    private static final String LONGEST_DISTANCE = "8888 mm";

    /** None of these parameters sends a request. */
    private static final List<String> READINGS =
            List.of("distanceFront", "distanceBack", "distanceLeft", "distanceRight", "x", "y", "heading", "model");

    private final transient MajicBot bot;
    private final transient Supplier<Optional<RosScene>> scenes;
    private final transient RosDrawing drawing = new RosDrawing();
    private final ZoomableMap map = new ZoomableMap(drawing);
    private final transient RosCamera camera;
    private final DriveGauges gauges = new DriveGauges();
    private final transient RosLights lights = new RosLights();
    private final TopicsPanel topics = new TopicsPanel();
    private final ReadingsPanel<MajicBot> readings = ReadingsPanel.ofParameters(LONGEST_READING, READINGS)
            .labelled(TEXTS::get)
            .paired(4, LONGEST_DISTANCE);

    private final Banner banner = new Banner();
    private transient @Nullable RosScene shown;

    private RosPanel(MajicBot bot, Supplier<Optional<RosScene>> scenes, Consumer<Boolean> cameraWatched) {
        super(bot);
        this.bot = bot;
        this.scenes = scenes;
        this.camera = new RosCamera(bot.time());
        camera.view().whenWatched(cameraWatched);
        camera.view()
                .setTitle(() -> Member.of(bot)
                        .map(member -> TEXTS.get("camera.robot", member.number()))
                        .orElseGet(() -> TEXTS.get("camera")));
        map.getAccessibleContext().setAccessibleName(TEXTS.get("map"));
        add(map);
        add(gauges);
        add(lights.panel());
        add(topics);
        add(readings);
        add(banner);
        arrange(false);
    }

    /**
     * Makes the panel; on the event dispatch thread.
     *
     * @param scenes gives what to show, on any thread; empty before the first report of the robot
     * @param cameraWatched is called on the event dispatch thread when the picture of the camera becomes visible or
     *     invisible; pictures then come by {@link MajicBot#addListener}
     */
    public static JComponent create(
            MajicBot bot, Supplier<Optional<RosScene>> scenes, Consumer<Boolean> cameraWatched) {
        return of(bot, scenes, cameraWatched);
    }

    /** As {@link #create}, which does not name this class: a driver loads it only where there is a window. */
    static RosPanel of(MajicBot bot, Supplier<Optional<RosScene>> scenes, Consumer<Boolean> cameraWatched) {
        RosPanel panel = new RosPanel(bot, scenes, cameraWatched);
        panel.refreshIfChanged();
        return panel;
    }

    /** Places everything; a robot without a camera leaves its space to the others. */
    private void arrange(boolean hasCamera) {
        List<SidePane> asides = new ArrayList<>();
        if (hasCamera) {
            add(camera.view());
            asides.add(SidePane.shaped(camera.view()));
        } else {
            remove(camera.view());
        }
        asides.add(SidePane.of(gauges));
        asides.add(SidePane.of(lights.panel()));
        asides.add(SidePane.spare(topics));
        setLayout(new Dashboard(map, 0, asides, readings).under(banner));
        revalidate();
        repaint();
    }

    @Override
    public void addNotify() {
        super.addNotify();
        bot.addListener(camera);
    }

    @Override
    public void removeNotify() {
        bot.removeListener(camera);
        super.removeNotify();
    }

    @Override
    protected void stateReceived(BotState state) {
        scenes.get().ifPresent(scene -> drawing.record(state.pose(), scene.scan()));
    }

    @Override
    protected void refresh() {
        readings.show(bot, bot.isConnected());
        banner.show(staleness(), false);
        camera.view().setCurrent(bot.isConnected());
        scenes.get().or(this::old).ifPresentOrElse(this::show, () -> lights.show(bot.connection()));
    }

    /** Returns what was shown last, while a new connection has reported nothing yet. */
    private Optional<RosScene> old() {
        return Optional.ofNullable(shown).map(scene -> scene.before(bot.connection()));
    }

    private void show(RosScene scene) {
        boolean hadCamera = shown != null && shown.robot().hasCamera();
        if (scene.robot().hasCamera() != hadCamera) {
            arrange(scene.robot().hasCamera());
        }
        shown = scene;
        BotState state = bot.state();
        drawing.show(scene, state.pose());
        map.repaint();
        gauges.setCurrent(scene.isConnected());
        gauges.showMotion(
                state.speedMmPerSec(),
                scene.robot().speedLimits(),
                state.turnRateDegPerSec(),
                scene.robot().turnLimits());
        RosScene.Battery battery = scene.battery();
        gauges.showBattery(battery.volts(), battery.percent(), battery.charging(), battery.charger());
        lights.show(scene);
        topics.show(scene);
    }

    /** Shows a recorded picture; on any thread. */
    void showPicture(byte[] file) {
        camera.see(() -> file);
    }

    /** Shows that no picture was recorded at this time; on the event dispatch thread. */
    void missPicture() {
        camera.miss(TEXTS.get("camera.notRecorded"));
    }
}
