package majic.gui.kit;

import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;

/** Runs an action when a field has lost the focus. */
public final class FocusLeft extends FocusAdapter {
    private final Runnable action;

    public FocusLeft(Runnable action) {
        this.action = action;
    }

    @Override
    public void focusLost(FocusEvent event) {
        action.run();
    }
}
