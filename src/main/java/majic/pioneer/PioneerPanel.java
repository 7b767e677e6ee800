package majic.pioneer;

import java.awt.BorderLayout;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.Timer;
import majic.bot.BotListener;
import majic.bot.BotState;
import majic.bot.MajicBot;

/** Shows one Pioneer from above with what its sonars hear, and its numbers. Looks at the robot ten times a second. */
final class PioneerPanel extends JPanel {
    private static final long serialVersionUID = 1;
    private static final int REFRESH_MS = 100;

    private final transient MajicPioneer bot;
    private final PioneerView view = new PioneerView();
    private final PioneerNumbers numbers = new PioneerNumbers();
    private final transient News news = new News();
    private final Timer refresh = new Timer(REFRESH_MS, event -> refresh());

    private PioneerPanel(MajicPioneer bot) {
        super(new BorderLayout(12, 12));
        this.bot = bot;
        add(view, BorderLayout.CENTER);
        add(numbers, BorderLayout.EAST);
    }

    static JComponent create(MajicPioneer bot) {
        return new PioneerPanel(bot);
    }

    @Override
    public void addNotify() {
        super.addNotify();
        bot.addListener(news);
        news.came = true;
        refresh.start();
    }

    @Override
    public void removeNotify() {
        refresh.stop();
        bot.removeListener(news);
        super.removeNotify();
    }

    /** On the event thread; the driver's threads only leave word that there is something to see. */
    private void refresh() {
        Session session = bot.session();
        if (news.came && session != null && session.hasSpoken()) {
            news.came = false;
            PioneerState state = session.state();
            view.show(session.model(), state);
            numbers.show(state, bot.connection());
        }
    }

    /** Hears on the driver's threads. */
    private static final class News implements BotListener {
        private volatile boolean came;

        @Override
        public void stateChanged(MajicBot from, BotState state) {
            came = true;
        }

        @Override
        public void connectionChanged(MajicBot from, MajicBot.Connection connection) {
            came = true;
        }
    }
}
