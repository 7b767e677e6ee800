package majic.gui;

import java.util.List;
import javax.swing.JButton;
import javax.swing.JPanel;
import javax.swing.SwingConstants;
import net.miginfocom.swing.MigLayout;

/** The row of buttons at the top, with STOP at its end. */
final class ButtonPane extends JPanel {
    private static final long serialVersionUID = 1L;

    ButtonPane(List<FrameAction> actions, StopPanel stop) {
        super(new MigLayout("insets 6 8 6 8, gap 2", "", "[fill]"));
        actions.forEach(action -> add(button(action), "h 52!, sizegroup buttons"));
        add(stop, "push, alignx right, gapleft 8");
    }

    private static JButton button(FrameAction action) {
        JButton button = new JButton(action);
        button.setName((String) action.getValue(FrameAction.NAME));
        button.setVerticalTextPosition(SwingConstants.BOTTOM);
        button.setHorizontalTextPosition(SwingConstants.CENTER);
        button.setFocusable(false);
        button.putClientProperty("JButton.buttonType", "toolBarButton");
        return button;
    }
}
