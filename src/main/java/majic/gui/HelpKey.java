package majic.gui;

import java.awt.KeyEventDispatcher;
import java.awt.KeyboardFocusManager;
import java.awt.event.KeyEvent;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.MenuSelectionManager;
import majic.gui.kit.HelpTopic;

/** Makes F1 open the help in every window and dialog, at the section of the guide that explains what has the focus. */
final class HelpKey implements KeyEventDispatcher, AutoCloseable {
    private final Consumer<Optional<String>> help;

    /**
     * Creates the key; {@link #install()} makes it work.
     *
     * @param help shows a section of the guide, or the beginning of the help
     */
    HelpKey(Consumer<Optional<String>> help) {
        this.help = help;
    }

    void install() {
        KeyboardFocusManager.getCurrentKeyboardFocusManager().addKeyEventDispatcher(this);
    }

    /** Runs before the focused component and the menus receive the key, which is not passed on. */
    @Override
    public boolean dispatchKeyEvent(KeyEvent event) {
        if (event.getKeyCode() != KeyEvent.VK_F1 || event.getModifiersEx() != 0) {
            return false;
        }
        if (event.getID() == KeyEvent.KEY_PRESSED) {
            MenuSelectionManager.defaultManager().clearSelectedPath();
            help.accept(HelpTopic.of(event.getComponent()));
        }
        return true;
    }

    @Override
    public void close() {
        KeyboardFocusManager.getCurrentKeyboardFocusManager().removeKeyEventDispatcher(this);
    }
}
