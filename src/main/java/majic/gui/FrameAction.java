package majic.gui;

import java.awt.Toolkit;
import java.awt.event.ActionEvent;
import javax.swing.AbstractAction;
import javax.swing.Action;
import javax.swing.Icon;
import javax.swing.KeyStroke;
import majic.gui.kit.Pictures;

/** Something the window can do, from which both its button and its menu entry are made. */
final class FrameAction extends AbstractAction {
    private static final long serialVersionUID = 1L;
    private static final int LARGE_ICON = 22;

    private final transient Runnable action;

    /**
     * An action without a key.
     *
     * @param icon name of one of our pictures, without {@code .svg}
     * @param tip one line for people
     */
    FrameAction(String name, String icon, String tip, Runnable action) {
        super(name);
        this.action = action;
        putValue(SHORT_DESCRIPTION, tip);
        putValue(LARGE_ICON_KEY, Pictures.later(icon, LARGE_ICON));
    }

    /** Gives the action a key, together with Ctrl (Cmd on a Mac). */
    FrameAction withKey(int keyCode) {
        int menuKey = Toolkit.getDefaultToolkit().getMenuShortcutKeyMaskEx();
        putValue(Action.ACCELERATOR_KEY, KeyStroke.getKeyStroke(keyCode, menuKey));
        return this;
    }

    /** Reads the picture; may wait. */
    void readPicture() {
        Pictures.read((Icon) getValue(LARGE_ICON_KEY));
    }

    @Override
    public void actionPerformed(ActionEvent event) {
        action.run();
    }
}
