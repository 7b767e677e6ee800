package majic.gui.kit;

import java.awt.Toolkit;
import java.awt.event.ActionEvent;
import javax.swing.AbstractAction;
import javax.swing.Action;
import javax.swing.KeyStroke;
import majic.text.Texts;

/** An action of the window; its button and its menu entry are both made from it. */
public final class IconAction extends AbstractAction {
    private static final long serialVersionUID = 1L;
    private static final Texts TEXTS = Texts.of(IconAction.class);
    private static final int LARGE_ICON = 22;

    private final transient Runnable action;
    private boolean opensDialog;

    /**
     * Creates an action without a key.
     *
     * @param tip tool tip, one line
     */
    public IconAction(String name, Pictogram icon, String tip, Runnable action) {
        super(name);
        this.action = action;
        putValue(SHORT_DESCRIPTION, tip);
        putValue(LARGE_ICON_KEY, Icons.of(icon, LARGE_ICON));
    }

    /** Sets the action's key, which is pressed together with Ctrl (Cmd on a Mac). */
    public IconAction withKey(int keyCode) {
        return withKey(
                KeyStroke.getKeyStroke(keyCode, Toolkit.getDefaultToolkit().getMenuShortcutKeyMaskEx()));
    }

    /** Sets the action's key. */
    public IconAction withKey(KeyStroke key) {
        putValue(Action.ACCELERATOR_KEY, key);
        return this;
    }

    /** Marks this as an action that opens a dialog first; the text of its menu entry ends with an ellipsis then. */
    public IconAction openingDialog() {
        opensDialog = true;
        return this;
    }

    /** Returns the text of the action's menu entry. Its button has the name alone, which is shorter. */
    public String entryText() {
        String name = (String) getValue(NAME);
        return opensDialog ? TEXTS.get("opensDialog", name) : name;
    }

    @Override
    public void actionPerformed(ActionEvent event) {
        action.run();
    }
}
