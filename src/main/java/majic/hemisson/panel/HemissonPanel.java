package majic.hemisson.panel;

import java.util.List;
import java.util.concurrent.Executor;
import java.util.function.Supplier;
import javax.swing.JComponent;
import javax.swing.SwingUtilities;
import majic.bot.BotState;
import majic.bot.MajicBot;
import majic.panel.Banner;
import majic.panel.Dashboard;
import majic.panel.ReadingsPanel;
import majic.panel.RefreshingPanel;
import majic.panel.SidePane;
import majic.panel.map.ZoomableMap;
import majic.text.Texts;

/**
 * Shows a Hemisson from above with its readings where its sensors are, its estimated way, the quality of its line, and
 * advice for the user when nothing else can stop it. It sends nothing but clicks on LEDs and the buzzer.
 */
public final class HemissonPanel extends RefreshingPanel {
    private static final long serialVersionUID = 1;

    private final transient Supplier<HemissonScene> views;
    private final HemissonDrawing drawing;
    private final transient FloorDrawing floor = new FloorDrawing();
    private final ZoomableMap map = new ZoomableMap(floor);
    private final transient HemissonLights lights = new HemissonLights();
    private final ReadingsPanel<HemissonScene> readings = HemissonReadings.panel();
    private final transient HemissonAdvice advice = new HemissonAdvice();
    private final Banner banner = new Banner();

    private HemissonPanel(MajicBot bot, Supplier<HemissonScene> views, Executor background) {
        super(bot);
        this.views = views;
        this.drawing = new HemissonDrawing(
                views.get(), new LedSwitch(bot, background, part -> part.isOn(views.get()), this::refused));
        map.getAccessibleContext()
                .setAccessibleName(Texts.of(HemissonPanel.class).get("map"));
        add(drawing);
        add(lights.panel());
        add(map);
        add(readings);
        add(banner);
        List<SidePane> asides = List.of(SidePane.of(lights.panel()), SidePane.stretched(map));
        setLayout(new Dashboard(drawing, 1, asides, readings).under(banner));
    }

    /**
     * Makes the panel; on the event dispatch thread.
     *
     * @param views takes what is to be shown; called by any thread
     * @param background runs a task on a thread of its own, for commands that wait for the robot
     */
    public static JComponent create(MajicBot bot, Supplier<HemissonScene> views, Executor background) {
        HemissonPanel panel = new HemissonPanel(bot, views, background);
        panel.refreshIfChanged();
        return panel;
    }

    @Override
    protected void stateReceived(BotState state) {
        floor.poseReported(state.pose());
    }

    @Override
    protected void refresh() {
        HemissonScene view = views.get();
        readings.show(view, view.isConnected());
        lights.show(view);
        HemissonAdvice.Words words = advice.on(view, System.nanoTime());
        banner.show(words.text().isEmpty() ? staleness() : words.text(), words.urgent());
        floor.show(view);
        map.repaint();
        drawing.show(view);
    }

    /** Called on the thread that waited for the robot. */
    private void refused(String why) {
        SwingUtilities.invokeLater(() -> {
            advice.refused(why, System.nanoTime());
            refresh();
        });
    }
}
