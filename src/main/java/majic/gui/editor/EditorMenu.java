package majic.gui.editor;

import java.awt.Toolkit;
import java.awt.event.KeyEvent;
import javax.swing.Action;
import javax.swing.JMenu;
import javax.swing.JMenuBar;
import javax.swing.JMenuItem;
import javax.swing.KeyStroke;
import majic.gui.kit.Mnemonics;
import majic.text.Texts;
import org.fife.ui.rtextarea.RTextArea;

/** The menu bar of the editor. */
final class EditorMenu extends JMenuBar {
    private static final long serialVersionUID = 1L;
    private static final Texts TEXTS = Texts.of(EditorMenu.class);

    EditorMenu(EditorWindow window, EditorContext context, EditorActions actions) {
        add(file(window, context, actions));
        add(edit(actions));
        add(menu(TEXTS.get("menu.run"), actions.run, actions.runSelection, actions.step, actions.pause, actions.end));
        Mnemonics.assign(this);
    }

    private static JMenu file(EditorWindow window, EditorContext context, EditorActions actions) {
        JMenu file = menu(TEXTS.get("menu.file"), actions.newScript, actions.open);
        file.add(recent(window, context));
        file.addSeparator();
        addAll(file, actions.save, actions.saveAs);
        file.addSeparator();
        addAll(file, actions.makeAct);
        file.addSeparator();
        addAll(file, actions.close);
        return file;
    }

    private static JMenu edit(EditorActions actions) {
        JMenu edit = new JMenu(TEXTS.get("menu.edit"));
        edit.add(text(RTextArea.UNDO_ACTION, TEXTS.get("menu.undo"), KeyEvent.VK_Z));
        edit.add(text(RTextArea.REDO_ACTION, TEXTS.get("menu.redo"), KeyEvent.VK_Y));
        edit.addSeparator();
        edit.add(text(RTextArea.CUT_ACTION, TEXTS.get("menu.cut"), KeyEvent.VK_X));
        edit.add(text(RTextArea.COPY_ACTION, TEXTS.get("menu.copy"), KeyEvent.VK_C));
        edit.add(text(RTextArea.PASTE_ACTION, TEXTS.get("menu.paste"), KeyEvent.VK_V));
        edit.add(text(RTextArea.SELECT_ALL_ACTION, TEXTS.get("menu.selectAll"), KeyEvent.VK_A));
        edit.addSeparator();
        addAll(edit, actions.find);
        return edit;
    }

    /**
     * Returns an entry for an action of the library, which has names in the language of the system. The text handles
     * the key itself; the entry shows it.
     */
    private static JMenuItem text(int action, String name, int keyCode) {
        JMenuItem item = new JMenuItem(RTextArea.getAction(action));
        item.setText(name);
        item.setMnemonic(0);
        item.setAccelerator(
                KeyStroke.getKeyStroke(keyCode, Toolkit.getDefaultToolkit().getMenuShortcutKeyMaskEx()));
        item.setIcon(null);
        item.setToolTipText(null);
        return item;
    }

    private static JMenu recent(EditorWindow window, EditorContext context) {
        JMenu recent = new JMenu(TEXTS.get("menu.recent"));
        recent.addChangeListener(change -> {
            if (recent.isSelected()) {
                RecentMenu.fill(recent, new RecentFiles(context.settings(), RecentFiles.SCRIPTS), window::open);
            }
        });
        return recent;
    }

    private static JMenu menu(String name, Action... actions) {
        JMenu menu = new JMenu(name);
        addAll(menu, actions);
        return menu;
    }

    private static void addAll(JMenu menu, Action... actions) {
        for (Action action : actions) {
            menu.add(new JMenuItem(action)).setToolTipText(null);
        }
    }
}
