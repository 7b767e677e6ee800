package majic.gui.command;

import java.util.List;
import javax.swing.JMenuItem;
import javax.swing.JPopupMenu;

/** The context menu of the command line: editing, and the earlier commands. */
final class LineMenu extends JPopupMenu {
    private static final long serialVersionUID = 1L;

    private final CommandLine line;
    private final transient List<JMenuItem> ofSelection;
    private final JMenuItem all;

    LineMenu(CommandLine line) {
        this.line = line;
        ofSelection = List.of(
                MenuEntry.of("cut", MessagePane.MENU_KEY + "X", line::cut),
                MenuEntry.of("copy", MessagePane.MENU_KEY + "C", line::copy));
        all = MenuEntry.of("selectAll", MessagePane.MENU_KEY + "A", line::selectAll);
        ofSelection.forEach(this::add);
        add(MenuEntry.of("paste", MessagePane.MENU_KEY + "V", line::paste));
        add(all);
        addSeparator();
        add(MenuEntry.of("earlier", "UP", line::recallOlder));
        add(MenuEntry.of("later", "DOWN", line::recallNewer));
        add(MenuEntry.of("searchEarlier", "ctrl R", line::searchOrNext));
    }

    /** Paste is always enabled, since the owner of the clipboard may answer late. */
    @Override
    protected void firePopupMenuWillBecomeVisible() {
        ofSelection.forEach(entry -> entry.setEnabled(line.getSelectedText() != null));
        all.setEnabled(!line.getText().isEmpty());
        super.firePopupMenuWillBecomeVisible();
    }
}
