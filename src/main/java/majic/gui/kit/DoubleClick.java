package majic.gui.kit;

import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;

/** Runs an action after a double click. */
public final class DoubleClick extends MouseAdapter {
    private final Runnable action;

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
