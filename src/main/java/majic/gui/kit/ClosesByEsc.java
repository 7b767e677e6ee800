package majic.gui.kit;

/**
 * Implemented by a component that lets Esc close something in it, such as a list of completions. While it or a
 * component inside it has the focus and something is open, Esc closes that and does not stop robots.
 */
public interface ClosesByEsc {
    /** Returns whether Esc has something to close now. Called on the event dispatch thread, before the key arrives. */
    boolean hasToClose();
}
