package majic.hemisson;

import javax.swing.JComponent;
import majic.panel.NewsPanel;
import majic.panel.NumbersBeside;

/** Shows a Hemisson from above with its readings where its sensors sit, and what else is known of it in figures. */
final class HemissonPanel extends NewsPanel {
    private static final long serialVersionUID = 1;

    private final transient MajicHemisson bot;
    private final HemissonNumbers numbers = new HemissonNumbers();
    private final HemissonDrawing drawing;

    private HemissonPanel(MajicHemisson bot) {
        super(bot);
        this.bot = bot;
        this.drawing = new HemissonDrawing(HemissonView.of(bot));
        add(drawing);
        add(numbers);
        setLayout(new NumbersBeside(drawing, numbers));
    }

    /** Makes the panel; on the event dispatch thread. */
    static JComponent create(MajicHemisson bot) {
        HemissonPanel panel = new HemissonPanel(bot);
        panel.refreshOnNews();
        return panel;
    }

    @Override
    protected void refresh() {
        HemissonView view = HemissonView.of(bot);
        numbers.show(view);
        drawing.show(view);
    }
}
