package majic.pioneer;

import java.util.List;
import javax.swing.JComponent;
import majic.bot.BotState;
import majic.panel.Aside;
import majic.panel.Dashboard;
import majic.panel.NewsPanel;
import majic.panel.ZoomableMap;

/**
 * Shows one Pioneer: a map with the robot, its sonar cones, what they met and the way it came; gauges, lights and readings.
 * It only shows: nothing in it sends the robot anything, so nothing can be switched by a slip of the mouse.
 */
final class PioneerPanel extends NewsPanel {
    private static final long serialVersionUID = 1;

    private final transient MajicPioneer bot;
    private final transient PioneerDrawing drawing = new PioneerDrawing();
    private final ZoomableMap map = new ZoomableMap(drawing);
    private final GaugesPanel gauges = new GaugesPanel();
    private final transient PioneerLights lights = new PioneerLights();
    private final PioneerNumbers numbers = new PioneerNumbers();

    private PioneerPanel(MajicPioneer bot) {
        super(bot);
        this.bot = bot;
        map.getAccessibleContext().setAccessibleName("Map of the Pioneer, its sonar echoes and its way");
        add(map);
        add(gauges);
        add(lights.panel());
        add(numbers);
        List<Aside> asides = List.of(Aside.of(gauges), Aside.of(lights.panel()));
        setLayout(new Dashboard(map, 0, asides, numbers));
    }

    /** Makes the panel; on the event dispatch thread. */
    static JComponent create(MajicPioneer bot) {
        PioneerPanel panel = new PioneerPanel(bot);
        panel.refreshOnNews();
        return panel;
    }

    @Override
    protected void heard(BotState state) {
        Session session = bot.session();
        if (session != null && session.hasSpoken()) {
            drawing.hear(session.model(), session.state());
        }
    }

    @Override
    protected void refresh() {
        numbers.show(bot);
        Session session = bot.session();
        if (session == null || !session.hasSpoken()) {
            lights.show(bot.connection());
            return;
        }
        PioneerScene scene = PioneerScene.of(bot, session);
        drawing.show(scene);
        map.repaint();
        gauges.show(scene);
        lights.show(scene);
    }
}
