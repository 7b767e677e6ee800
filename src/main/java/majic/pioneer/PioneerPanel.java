package majic.pioneer;

import javax.swing.JComponent;
import majic.panel.NewsPanel;
import majic.panel.NumbersBeside;

/** Shows one Pioneer from above with what its sonars hear, and its readings in numbers. */
final class PioneerPanel extends NewsPanel {
    private static final long serialVersionUID = 1;

    private final transient MajicPioneer bot;
    private final PioneerNumbers numbers = new PioneerNumbers();
    private final PioneerDrawing drawing = new PioneerDrawing();

    private PioneerPanel(MajicPioneer bot) {
        super(bot);
        this.bot = bot;
        add(drawing);
        add(numbers);
        setLayout(new NumbersBeside(drawing, numbers));
    }

    /** Makes the panel; on the event dispatch thread. */
    static JComponent create(MajicPioneer bot) {
        PioneerPanel panel = new PioneerPanel(bot);
        panel.refreshOnNews();
        return panel;
    }

    @Override
    protected void refresh() {
        numbers.show(bot);
        Session session = bot.session();
        if (session != null && session.hasSpoken()) {
            drawing.show(PioneerScene.of(session, bot.isConnected()));
        }
    }
}
