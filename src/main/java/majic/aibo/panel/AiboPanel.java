package majic.aibo.panel;

import java.util.List;
import java.util.function.Consumer;
import java.util.function.Function;
import javax.swing.JComponent;
import javax.swing.JPanel;
import majic.aibo.body.DogState;
import majic.bot.MajicBot;
import majic.panel.Banner;
import majic.panel.Dashboard;
import majic.panel.ReadingsPanel;
import majic.panel.RefreshingPanel;
import majic.panel.SidePane;
import majic.text.Texts;
import net.miginfocom.swing.MigLayout;

/**
 * Shows one dog: the picture of its camera, a drawing with its joints, LEDs and touch sensors, and its readings. Only
 * the sliders of the head move it; everything else only reads.
 */
public final class AiboPanel extends RefreshingPanel {
    private static final long serialVersionUID = 1;
    private static final Texts TEXTS = Texts.of(AiboPanel.class);

    /** The share of the width for the camera and the controls. */
    private static final double ASIDES = 0.42;

    private static final String LONGEST_READING = "-88888 mm";

    /** None of them asks the dog. */
    private static final List<String> READINGS = List.of(
            "distanceFront",
            "distanceNear",
            "distance",
            "distanceChest",
            "bumped",
            "x",
            "y",
            "heading",
            "mouth",
            "tailPan",
            "tailTilt",
            "headSensor",
            "backSensorF",
            "backSensorM",
            "backSensorR",
            "accelX",
            "accelY",
            "accelZ");

    private final transient MajicBot bot;
    private final transient DogState dog;
    private final DogDrawing drawing;
    private final transient CameraPanel camera;
    private final HeadPanel head;
    private final BodyPanel body = new BodyPanel();
    private final ReadingsPanel<MajicBot> readings =
            ReadingsPanel.ofParameters(LONGEST_READING, READINGS).labelled(TEXTS::get);

    private final Banner banner = new Banner();

    private AiboPanel(MajicBot bot, DogState dog, Function<PanelPoller.PictureReceiver, Consumer<Boolean>> pictures) {
        super(bot);
        this.bot = bot;
        this.dog = dog;
        this.drawing = new DogDrawing(dog);
        this.camera = new CameraPanel(bot);
        this.head = new HeadPanel(bot, dog.senses());
        camera.view().whenWatched(pictures.apply(camera));
        JPanel controls = controls();
        add(drawing);
        add(camera.view());
        add(controls);
        add(readings);
        add(banner);
        List<SidePane> asides = List.of(SidePane.shaped(camera.view()), SidePane.of(controls));
        setLayout(new Dashboard(drawing, ASIDES, asides, readings).under(banner));
    }

    private JPanel controls() {
        JPanel controls =
                new JPanel(new MigLayout("insets 0, wrap 1, fillx, gap 0 4, novisualpadding", "[grow, fill]"));
        controls.setOpaque(false);
        controls.add(head);
        controls.add(body);
        return controls;
    }

    /**
     * Makes the panel; on the event dispatch thread.
     *
     * @param dog what is drawn
     * @param pictures takes what the panel shows pictures with, and returns what is called when they begin or cease to
     *     be visible
     */
    public static JComponent create(
            MajicBot bot, DogState dog, Function<PanelPoller.PictureReceiver, Consumer<Boolean>> pictures) {
        AiboPanel panel = new AiboPanel(bot, dog, pictures);
        panel.refreshIfChanged();
        return panel;
    }

    @Override
    protected void refresh() {
        boolean connected = bot.isConnected();
        head.refresh();
        body.refresh(dog.senses(), connected);
        readings.show(bot, connected);
        banner.show(staleness(), false);
        camera.view().setCurrent(connected);
        drawing.setEnabled(connected);
        drawing.refresh();
    }
}
