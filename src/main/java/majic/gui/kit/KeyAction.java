package majic.gui.kit;

import java.awt.event.ActionEvent;
import javax.swing.AbstractAction;
import javax.swing.JComponent;
import javax.swing.KeyStroke;

/** A key that runs an action while a component, or a component of its window, has the focus. */
public final class KeyAction extends AbstractAction {
    private static final long serialVersionUID = 1L;

    private final transient Runnable action;

    private KeyAction(Runnable action) {
        this.action = action;
    }

    /**
     * Binds a key; replaces an earlier binding of it.
     *
     * @param condition where the focus must be, one of the constants of {@link JComponent} such as
     *     {@link JComponent#WHEN_FOCUSED}
     */
    public static void bind(JComponent component, int condition, KeyStroke key, Runnable action) {
        component.getInputMap(condition).put(key, key);
        component.getActionMap().put(key, new KeyAction(action));
    }

    @Override
    public void actionPerformed(ActionEvent event) {
        action.run();
    }
}
