package majic.gui.command;

import javax.swing.JMenuItem;
import javax.swing.KeyStroke;
import majic.text.Texts;

/** Creates the entries of context menus. */
final class MenuEntry {
    private static final Texts TEXTS = Texts.of(MenuEntry.class);

    private MenuEntry() {}

    /**
     * Creates an entry.
     *
     * @param textKey of its text; also its name
     * @param key is only shown, since the component has the keys; empty for none
     */
    static JMenuItem of(String textKey, String key, Runnable action) {
        JMenuItem item = new JMenuItem(TEXTS.get(textKey));
        item.addActionListener(event -> action.run());
        item.setName(textKey);
        item.setAccelerator(key.isEmpty() ? null : KeyStroke.getKeyStroke(key));
        return item;
    }
}
