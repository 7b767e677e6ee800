package majic.hemisson;

import java.awt.BorderLayout;
import java.util.Locale;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.stream.Collectors;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.Timer;
import majic.bot.BotListener;
import majic.bot.BotState;
import majic.bot.MajicBot;

/**
 * Shows a Hemisson from above with its readings where its sensors sit, and what else is known of it in figures. News
 * from the robot only leaves a mark, on whatever thread; a timer of the event thread looks for it ten times a second.
 */
final class HemissonPanel extends JPanel {
    private static final long serialVersionUID = 1;

    private static final int REFRESH_MS = 100;

    private final transient MajicHemisson bot;
    private final transient BotListener news = new News();
    private final AtomicBoolean changed = new AtomicBoolean(true);
    private final Timer timer = new Timer(REFRESH_MS, tick -> refresh());
    private final HemissonDrawing drawing;
    private final JLabel motion = new JLabel();
    private final JLabel line = new JLabel();

    private HemissonPanel(MajicHemisson bot) {
        super(new BorderLayout(8, 8));
        this.bot = bot;
        this.drawing = new HemissonDrawing(HemissonView.of(bot));
        JPanel figures = new JPanel(new BorderLayout());
        figures.add(motion, BorderLayout.NORTH);
        figures.add(line, BorderLayout.CENTER);
        figures.add(
                new JLabel("No watchdog: if the link is lost, lift it or press 5 on a TV remote"), BorderLayout.SOUTH);
        setBorder(BorderFactory.createEmptyBorder(8, 8, 8, 8));
        add(drawing, BorderLayout.CENTER);
        add(figures, BorderLayout.SOUTH);
    }

    /** Makes the panel; on the event dispatch thread. */
    static JComponent create(MajicHemisson bot) {
        HemissonPanel panel = new HemissonPanel(bot);
        panel.refresh();
        return panel;
    }

    @Override
    public void addNotify() {
        super.addNotify();
        bot.addListener(news);
        changed.set(true);
        timer.start();
    }

    @Override
    public void removeNotify() {
        timer.stop();
        bot.removeListener(news);
        super.removeNotify();
    }

    private void refresh() {
        if (changed.getAndSet(false)) {
            HemissonView view = HemissonView.of(bot);
            drawing.show(view);
            motion.setText(motionOf(view));
            line.setText(lineOf(view));
        }
    }

    private static String motionOf(HemissonView view) {
        BotState state = view.state();
        return String.format(
                Locale.ROOT,
                "wheels %d, %d · about %.0f mm/s, %.0f deg/s · about x %.0f, y %.0f mm, %.0f deg",
                view.wheels().left(),
                view.wheels().right(),
                state.speedMmPerSec(),
                state.turnRateDegPerSec(),
                state.pose().xMm(),
                state.pose().yMm(),
                state.pose().headingDeg());
    }

    private static String lineOf(HemissonView view) {
        String switches = view.switches().stream().map(String::valueOf).collect(Collectors.joining(" "));
        return String.format(
                Locale.ROOT,
                "%s · round trip %.1f ms, %d answers, %d missed · switches %s · buzzer %s",
                view.connected() ? "connected" : "not connected",
                view.quality().roundTripMs(),
                view.quality().answers(),
                view.quality().misses(),
                switches.isEmpty() ? "?" : switches,
                view.buzzing() ? "on" : "off");
    }

    /** Marks that something is new; called on the driver's threads. */
    private final class News implements BotListener {
        @Override
        public void stateChanged(MajicBot who, BotState state) {
            changed.set(true);
        }

        @Override
        public void connectionChanged(MajicBot who, MajicBot.Connection connection) {
            changed.set(true);
        }
    }
}
