package majic.gui.editor;

import java.util.stream.Stream;
import javax.swing.Action;
import javax.swing.JMenu;
import javax.swing.JMenuBar;
import javax.swing.JMenuItem;
import javax.swing.event.MenuEvent;
import javax.swing.event.MenuListener;
import org.fife.ui.rtextarea.RTextArea;

/** The menu bar of the editor. */
final class EditorMenu extends JMenuBar {
    private static final long serialVersionUID = 1L;

    EditorMenu(EditorWindow window, EditorContext context, EditorActions actions) {
        JMenu file = menu("File", 'F', item(actions.newScript, 'N'), item(actions.open, 'O'));
        file.add(recent(window, context));
        file.addSeparator();
        Stream.of(item(actions.save, 'S'), item(actions.saveAs, 'A')).forEach(file::add);
        file.addSeparator();
        file.add(item(actions.makeAct, 'M'));
        file.addSeparator();
        file.add(item(actions.close, 'C'));
        add(file);
        add(edit(actions));
        add(menu(
                "Run",
                'R',
                item(actions.run, 'R'),
                item(actions.runSelection, 'L'),
                item(actions.step, 'S'),
                item(actions.pause, 'P'),
                item(actions.end, 'E')));
    }

    private static JMenu edit(EditorActions actions) {
        JMenu edit =
                menu("Edit", 'E', text(RTextArea.UNDO_ACTION, "Undo", 'U'), text(RTextArea.REDO_ACTION, "Redo", 'R'));
        edit.addSeparator();
        Stream.of(
                        text(RTextArea.CUT_ACTION, "Cut", 'T'),
                        text(RTextArea.COPY_ACTION, "Copy", 'C'),
                        text(RTextArea.PASTE_ACTION, "Paste", 'P'),
                        text(RTextArea.SELECT_ALL_ACTION, "Select all", 'A'))
                .forEach(edit::add);
        edit.addSeparator();
        edit.add(item(actions.find, 'F'));
        return edit;
    }

    private static JMenuItem text(int action, String name, char mnemonic) {
        JMenuItem item = item(RTextArea.getAction(action), mnemonic);
        item.setText(name);
        item.setIcon(null);
        return item;
    }

    private static JMenu recent(EditorWindow window, EditorContext context) {
        JMenu recent = new JMenu("Open recent");
        recent.setMnemonic('R');
        recent.addMenuListener(new MenuListener() {
            @Override
            public void menuSelected(MenuEvent event) {
                RecentMenu.fill(recent, context.settings(), window::open);
            }

            @Override
            public void menuDeselected(MenuEvent event) {}

            @Override
            public void menuCanceled(MenuEvent event) {}
        });
        return recent;
    }

    private static JMenu menu(String name, char mnemonic, JMenuItem... items) {
        JMenu menu = new JMenu(name);
        menu.setMnemonic(mnemonic);
        Stream.of(items).forEach(menu::add);
        return menu;
    }

    private static JMenuItem item(Action action, char mnemonic) {
        JMenuItem item = new JMenuItem(action);
        item.setMnemonic(mnemonic);
        item.setToolTipText(null);
        return item;
    }
}
