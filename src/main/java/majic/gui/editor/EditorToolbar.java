package majic.gui.editor;

import java.util.List;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JSeparator;
import javax.swing.SwingConstants;
import majic.gui.kit.IconAction;
import majic.gui.kit.Palette;
import majic.gui.kit.PlainLabel;
import majic.gui.kit.StopButton;
import net.miginfocom.swing.MigLayout;

/** The buttons of the editor, the robots that the script commands, and STOP. */
final class EditorToolbar extends JPanel {
    private static final long serialVersionUID = 1L;

    private final JLabel caption = new JLabel("Commands");
    private final JLabel robots = new PlainLabel("scriptRobots", "");

    EditorToolbar(List<List<IconAction>> groups, StopButton stop) {
        super(new MigLayout("insets 6 8 6 8, gap 0", "", "[52!, fill]"));
        for (List<IconAction> group : groups) {
            group.forEach(action -> add(button(action), "wmin 56"));
            add(new JSeparator(SwingConstants.VERTICAL), "gap 6 6, h 36!, aligny center");
        }
        JPanel commands = new JPanel(new MigLayout("insets 0 6 0 6, gap 0, wrap 1, aligny center", "[grow, fill]"));
        commands.add(caption, "wmin 0");
        commands.add(robots, "wmin 0");
        add(commands, "wmin 0, pushx, growx");
        add(stop, "w 120!");
        caption.setForeground(Palette.faint());
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
        button.putClientProperty("JButton.buttonType", "toolBarButton");
        return button;
    }
}
