package majic.gui.plot;

import java.awt.event.KeyEvent;
import javax.swing.JComponent;
import javax.swing.KeyStroke;
import majic.panel.KeyAction;

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
        bind(KeyStroke.getKeyStroke('+'), () -> cursor.zoomTime(-1));
        bind(KeyStroke.getKeyStroke('-'), () -> cursor.zoomTime(1));
        bind(KeyStroke.getKeyStroke('0'), () -> model.zoom(null));
        bind(KeyStroke.getKeyStroke(' '), () -> model.pause(!model.isPaused()));
        bind(KeyStroke.getKeyStroke("LEFT"), () -> cursor.move(-1));
        bind(KeyStroke.getKeyStroke("RIGHT"), () -> cursor.move(1));
        bind(KeyStroke.getKeyStroke(KeyEvent.VK_LEFT, KeyEvent.SHIFT_DOWN_MASK), () -> cursor.move(-FAR));
        bind(KeyStroke.getKeyStroke(KeyEvent.VK_RIGHT, KeyEvent.SHIFT_DOWN_MASK), () -> cursor.move(FAR));
    }

    private void bind(KeyStroke stroke, Runnable action) {
        KeyAction.bind(view, JComponent.WHEN_FOCUSED, stroke, event -> action.run());
    }
}
