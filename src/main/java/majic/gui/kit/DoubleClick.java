package majic.gui.kit;

import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;

/** Does something when a place is clicked twice. */
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
