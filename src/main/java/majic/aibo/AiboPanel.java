package majic.aibo;

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
 * Shows one dog, drawn from above and from its side, with its readings in numbers. News only leave a mark, on whatever
 * thread; a timer of the event thread looks for it ten times a second.
 */
final class AiboPanel extends JPanel {
    private static final long serialVersionUID = 1;
    private static final int REFRESH_MS = 100;

    private final transient MajicAibo bot;
    private final transient AtomicBoolean news = new AtomicBoolean(true);
    private final transient BotListener listener = new News();
    private final Timer timer = new Timer(REFRESH_MS, tick -> refresh());
    private final AiboNumbers numbers = new AiboNumbers();
    private final DogDrawing drawing;

    private AiboPanel(MajicAibo bot) {
        super(null);
        this.bot = bot;
        this.drawing = new DogDrawing(bot.dog());
        add(drawing);
        add(numbers);
    }

    /** Makes the panel; on the event dispatch thread. */
    static JComponent create(MajicAibo bot) {
        AiboPanel panel = new AiboPanel(bot);
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
            numbers.show(bot);
            drawing.setEnabled(bot.isConnected());
            drawing.repaint();
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
