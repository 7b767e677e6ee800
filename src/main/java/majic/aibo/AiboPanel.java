package majic.aibo;

import javax.swing.JComponent;
import majic.panel.NewsPanel;
import majic.panel.NumbersBeside;

/** Shows one dog, drawn from above and from its side, with its readings in numbers. */
final class AiboPanel extends NewsPanel {
    private static final long serialVersionUID = 1;

    private final transient MajicAibo bot;
    private final AiboNumbers numbers = new AiboNumbers();
    private final DogDrawing drawing;

    private AiboPanel(MajicAibo bot) {
        super(bot);
        this.bot = bot;
        this.drawing = new DogDrawing(bot.dog());
        add(drawing);
        add(numbers);
        setLayout(new NumbersBeside(drawing, numbers));
    }

    /** Makes the panel; on the event dispatch thread. */
    static JComponent create(MajicAibo bot) {
        AiboPanel panel = new AiboPanel(bot);
        panel.refreshOnNews();
        return panel;
    }

    @Override
    protected void refresh() {
        numbers.show(bot);
        drawing.setEnabled(bot.isConnected());
        drawing.repaint();
    }
}
