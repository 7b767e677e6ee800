package majic.mavlink.panel;

import java.util.List;
import java.util.function.Consumer;
import javax.swing.JButton;
import javax.swing.JMenuItem;
import javax.swing.JPopupMenu;
import javax.swing.JRadioButtonMenuItem;
import majic.panel.ReadingsPanel;
import majic.text.Texts;

/**
 * Shows the mode of the autopilot, and a menu of those that can be set. A menu, since the arrow keys in a closed list
 * would set one mode after the other. For the event dispatch thread.
 */
final class ModeButton extends JButton {
    private static final long serialVersionUID = 1;
    private static final Texts TEXTS = Texts.of(ModeButton.class);

    private final transient Consumer<String> chosen;
    private String mode = ReadingsPanel.NONE;
    private transient List<String> modes = List.of();

    /**
     * Creates a button without a mode.
     *
     * @param chosen receives the mode that was chosen, which is not shown before the autopilot reports it
     */
    ModeButton(Consumer<String> chosen) {
        this.chosen = chosen;
        setName("mode");
        setToolTipText(TEXTS.get("mode.tip"));
        addActionListener(event -> menu().show(this, 0, getHeight()));
        show(mode, modes);
    }

    /**
     * Shows the mode.
     *
     * @param now the present one
     * @param settable those in the menu
     */
    void show(String now, List<String> settable) {
        mode = now;
        modes = settable;
        String words = TEXTS.get("mode", now);
        if (!words.equals(getText())) {
            setText(words);
        }
    }

    JPopupMenu menu() {
        JPopupMenu menu = new JPopupMenu();
        for (String name : modes) {
            JMenuItem item = new JRadioButtonMenuItem(name, name.equals(mode));
            item.setName("mode " + name);
            item.addActionListener(event -> chosen.accept(name));
            menu.add(item);
        }
        return menu;
    }
}
