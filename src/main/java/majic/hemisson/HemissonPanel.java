package majic.hemisson;

import java.awt.Dimension;
import java.awt.Rectangle;
import java.util.concurrent.atomic.AtomicBoolean;
import javax.swing.JComponent;
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
    private final transient AtomicBoolean news = new AtomicBoolean(true);
    private final transient BotListener listener = new News();
    private final Timer timer = new Timer(REFRESH_MS, tick -> refresh());
    private final HemissonNumbers numbers = new HemissonNumbers();
    private final HemissonDrawing drawing;

    private HemissonPanel(MajicHemisson bot) {
        super(null);
        this.bot = bot;
        this.drawing = new HemissonDrawing(HemissonView.of(bot));
        add(drawing);
        add(numbers);
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
        bot.addListener(listener);
        news.set(true);
        timer.start();
    }

    @Override
    public void removeNotify() {
        timer.stop();
        bot.removeListener(listener);
        super.removeNotify();
    }

    @Override
    public void doLayout() {
        int gap = numbers.gap() / 2;
        Rectangle room = new Rectangle(gap, gap, getWidth() - 2 * gap, getHeight() - 2 * gap);
        Rectangle claimed = numbers.claim(room);
        numbers.setBounds(claimed);
        boolean atFoot = claimed.y > room.y;
        int width = atFoot ? room.width : room.width - claimed.width - 2 * gap;
        int height = atFoot ? room.height - claimed.height - 2 * gap : room.height;
        drawing.setBounds(gap, gap, Math.max(0, width), Math.max(0, height));
    }

    @Override
    public Dimension getMinimumSize() {
        Dimension least = numbers.getMinimumSize();
        int gaps = numbers.gap();
        return new Dimension(least.width + gaps, least.height + gaps);
    }

    private void refresh() {
        if (news.getAndSet(false)) {
            HemissonView view = HemissonView.of(bot);
            numbers.show(view);
            drawing.show(view);
        }
    }

    /** Marks that there is something to show; called on the driver's threads. */
    private final class News implements BotListener {
        @Override
        public void stateChanged(MajicBot changed, BotState state) {
            news.set(true);
        }

        @Override
        public void connectionChanged(MajicBot changed, MajicBot.Connection connection) {
            news.set(true);
        }
    }
}
