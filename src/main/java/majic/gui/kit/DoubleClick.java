package majic.gui.kit;

import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;

/** Runs an action at each double click. */
public final class DoubleClick extends MouseAdapter {
    private final Runnable action;

    /** Creates a listener for a component. */
    public DoubleClick(Runnable action) {
        this.action = action;
    }

    @Override
    public void mouseClicked(MouseEvent event) {
        if (event.getClickCount() == 2) {
            action.run();
        }
    }
}
