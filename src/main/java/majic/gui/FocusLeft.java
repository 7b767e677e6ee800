package majic.gui;

import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;

/** Does something when a field has lost the focus. */
final class FocusLeft extends FocusAdapter {
    private final Runnable action;

    FocusLeft(Runnable action) {
        this.action = action;
    }

    @Override
    public void focusLost(FocusEvent event) {
        action.run();
    }
}
