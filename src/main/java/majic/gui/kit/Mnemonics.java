package majic.gui.kit;

import java.awt.CardLayout;
import java.awt.Component;
import java.awt.Container;
import java.awt.event.KeyEvent;
import java.util.HashSet;
import java.util.Set;
import java.util.stream.IntStream;
import javax.swing.AbstractButton;
import javax.swing.JComboBox;
import javax.swing.JFileChooser;
import javax.swing.JLabel;
import javax.swing.JMenu;
import javax.swing.JMenuBar;
import javax.swing.JTabbedPane;

/**
 * Assigns mnemonics: letters that, together with Alt, press a button, select a tab or focus a labelled field. Each is a
 * letter of the text, the first of a word if possible, and unique among the components that are visible together. A
 * mnemonic that is set already is kept. Must be used on the event dispatch thread.
 */
public final class Mnemonics {
    private final Set<Integer> taken;

    private Mnemonics(Set<Integer> taken) {
        this.taken = new HashSet<>(taken);
    }

    /** Assigns mnemonics to all buttons, tabs and labels of fields in a window. */
    public static void assign(Container content) {
        Mnemonics all = new Mnemonics(Set.of());
        all.reserve(content);
        all.visit(content);
    }

    /** Assigns mnemonics to the menus, and to the entries of each. */
    public static void assign(JMenuBar bar) {
        Mnemonics menus = new Mnemonics(Set.of());
        menus.reserve(bar);
        IntStream.range(0, bar.getMenuCount()).mapToObj(bar::getMenu).forEach(menu -> {
            menus.visit(menu);
            assign(menu);
        });
    }

    /** Assigns mnemonics to the entries of a menu. */
    public static void assign(JMenu menu) {
        Mnemonics entries = new Mnemonics(Set.of());
        for (Component entry : menu.getMenuComponents()) {
            entries.reserve(entry);
        }
        for (Component entry : menu.getMenuComponents()) {
            entries.visit(entry);
            if (entry instanceof JMenu inner) {
                assign(inner);
            }
        }
    }

    private void reserve(Component component) {
        if (component instanceof AbstractButton button && button.getMnemonic() != 0) {
            taken.add(button.getMnemonic());
        } else if (component instanceof JLabel label && label.getDisplayedMnemonic() != 0) {
            taken.add(label.getDisplayedMnemonic());
        }
        if (component instanceof Container container && !isClosed(component)) {
            for (Component child : container.getComponents()) {
                reserve(child);
            }
        }
    }

    private void visit(Component component) {
        if (component instanceof AbstractButton button) {
            visit(button);
        } else if (component instanceof JLabel label) {
            visit(label);
        } else if (component instanceof JTabbedPane tabs) {
            IntStream.range(0, tabs.getTabCount())
                    .filter(tab -> tabs.getMnemonicAt(tab) <= 0)
                    .forEach(tab -> tabs.setMnemonicAt(tab, take(tabs.getTitleAt(tab))));
            visitAlternatives(tabs);
        } else if (component instanceof Container container && !isClosed(component)) {
            if (container.getLayout() instanceof CardLayout) {
                visitAlternatives(container);
            } else {
                for (Component child : container.getComponents()) {
                    visit(child);
                }
            }
        }
    }

    /** Returns whether a component has keys of its own for what is in it. */
    private static boolean isClosed(Component component) {
        return component instanceof JComboBox || component instanceof JFileChooser;
    }

    private void visit(AbstractButton button) {
        String text = button.getText();
        if (text != null && button.getMnemonic() == 0) {
            button.setMnemonic(take(text));
        }
    }

    private void visit(JLabel label) {
        if (label.getLabelFor() != null && label.getDisplayedMnemonic() == 0) {
            label.setDisplayedMnemonic(take(label.getText()));
        }
    }

    /** Visits containers of which one is visible at a time; they may use the same letters. */
    private void visitAlternatives(Container container) {
        Set<Integer> used = new HashSet<>();
        for (Component child : container.getComponents()) {
            Mnemonics inner = new Mnemonics(taken);
            inner.visit(child);
            used.addAll(inner.taken);
        }
        taken.addAll(used);
    }

    /** Returns the key code of a letter of the text that is still free, and takes it; 0 if there is none. */
    private int take(String text) {
        int code = IntStream.concat(wordStarts(text), text.chars())
                .filter(Character::isLetter)
                .map(KeyEvent::getExtendedKeyCodeForChar)
                .filter(letter -> letter != KeyEvent.VK_UNDEFINED && !taken.contains(letter))
                .findFirst()
                .orElse(0);
        if (code != 0) {
            taken.add(code);
        }
        return code;
    }

    private static IntStream wordStarts(String text) {
        return IntStream.range(0, text.length())
                .filter(index -> index == 0 || text.charAt(index - 1) == ' ')
                .map(text::charAt);
    }
}
