package majic.gui.editor;

import java.util.ArrayList;
import java.util.List;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JSeparator;
import javax.swing.SwingConstants;
import majic.gui.kit.IconAction;
import majic.gui.kit.NamedLabel;
import majic.gui.kit.Palette;
import majic.gui.kit.StopButton;
import majic.text.Texts;
import net.miginfocom.swing.MigLayout;

/** The buttons of the editor, the robots that the script commands, and STOP. */
final class EditorToolbar extends JPanel {
    private static final long serialVersionUID = 1L;
    private static final Texts TEXTS = Texts.of(EditorToolbar.class);

    private static final int COMMANDS_WIDTH = 190;

    private final transient List<JButton> buttons = new ArrayList<>();
    private final JLabel caption = new JLabel(TEXTS.get("commands"));
    private final JLabel robots = new NamedLabel("scriptRobots", "");

    private int wordsWidth;

    EditorToolbar(List<List<IconAction>> groups, StopButton stop) {
        super(new MigLayout("insets 6 8 6 8, gap 0", "", "[52!, fill]"));
        for (List<IconAction> group : groups) {
            for (IconAction action : group) {
                JButton button = button(action);
                buttons.add(button);
                add(button, "wmin pref");
            }
            add(new JSeparator(SwingConstants.VERTICAL), "gap 6 6, h 36!, aligny center");
        }
        JPanel commands = new JPanel(new MigLayout("insets 0 6 0 6, gap 0, wrap 1, aligny center", "[grow, fill]"));
        commands.add(caption, "wmin 0");
        commands.add(robots, "wmin 0");
        add(commands, "pushx, growx, w 0:" + COMMANDS_WIDTH);
        add(stop, "wmin pref");
        caption.setForeground(Palette.faint());
    }

    /** Shows the icons alone where there is too little room for all texts. */
    @Override
    public void doLayout() {
        if (!buttons.get(0).getHideActionText()) {
            wordsWidth = getPreferredSize().width;
        }
        buttons.forEach(button -> button.setHideActionText(wordsWidth > getWidth()));
        super.doLayout();
    }

    /** Updates the colours for the look and feel. */
    @Override
    public void updateUI() {
        super.updateUI();
        if (caption != null) {
            caption.setForeground(Palette.faint());
        }
    }

    void showRobots(String names) {
        robots.setText(names);
        robots.setToolTipText(names);
    }

    private static JButton button(IconAction action) {
        JButton button = new JButton(action);
        button.setName("editor " + action.getValue(IconAction.NAME));
        button.setVerticalTextPosition(SwingConstants.BOTTOM);
        button.setHorizontalTextPosition(SwingConstants.CENTER);
        button.setFocusable(false);
        nameFor(action, button);
        action.addPropertyChangeListener(change -> nameFor(action, button));
        button.putClientProperty("JButton.buttonType", "toolBarButton");
        return button;
    }

    /** Keeps the name for screen readers, also while the button shows its icon alone. */
    private static void nameFor(IconAction action, JButton button) {
        button.getAccessibleContext().setAccessibleName((String) action.getValue(IconAction.NAME));
    }
}
