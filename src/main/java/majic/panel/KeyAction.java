package majic.panel;

import java.awt.event.ActionEvent;
import java.awt.event.ActionListener;
import javax.swing.AbstractAction;
import javax.swing.JComponent;
import javax.swing.KeyStroke;

/** A key that runs an action while a component, or a component of its window, has the focus. */
public final class KeyAction extends AbstractAction {
    private static final long serialVersionUID = 1L;

    private final transient ActionListener action;

    private KeyAction(ActionListener action) {
        this.action = action;
    }

    /**
     * Binds a key; replaces an earlier binding of it. Must be called on the event dispatch thread.
     *
     * @param component the component whose key it is
     * @param condition where the focus must be, one of the constants of {@link JComponent} such as
     *     {@link JComponent#WHEN_FOCUSED}
     * @param key the key
     * @param action runs on the event dispatch thread
     */
    public static void bind(JComponent component, int condition, KeyStroke key, ActionListener action) {
        component.getInputMap(condition).put(key, key);
        component.getActionMap().put(key, new KeyAction(action));
    }

    @Override
    public void actionPerformed(ActionEvent event) {
        action.actionPerformed(event);
    }
}
