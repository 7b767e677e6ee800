package majic.gui.plot;

import java.awt.event.ActionEvent;
import javax.swing.AbstractAction;
import javax.swing.JComponent;
import javax.swing.KeyStroke;

/** The keys of a chart that has the focus: they zoom, pause, and move the cursor. */
final class ChartKeys {
    private static final int FAR = 10;

    private final JComponent view;
    private final PlotModel model;
    private final ChartCursor cursor;

    ChartKeys(JComponent view, PlotModel model, ChartCursor cursor) {
        this.view = view;
        this.model = model;
        this.cursor = cursor;
    }

    void install() {
        bind("typed +", () -> cursor.zoomTime(-1));
        bind("typed -", () -> cursor.zoomTime(1));
        bind("typed 0", () -> model.zoom(null));
        bind("typed  ", () -> model.pause(!model.isPaused()));
        bind("LEFT", () -> cursor.move(-1));
        bind("RIGHT", () -> cursor.move(1));
        bind("shift LEFT", () -> cursor.move(-FAR));
        bind("shift RIGHT", () -> cursor.move(FAR));
    }

    private void bind(String key, Runnable action) {
        view.getInputMap().put(KeyStroke.getKeyStroke(key), key);
        view.getActionMap().put(key, new AbstractAction(key) {
            private static final long serialVersionUID = 1L;

            @Override
            public void actionPerformed(ActionEvent event) {
                action.run();
            }
        });
    }
}
