package majic.gui;

import java.awt.BorderLayout;
import java.util.List;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JPanel;
import javax.swing.SwingConstants;
import net.miginfocom.swing.MigLayout;

/** The row of buttons at the top, with STOP at its end, which is never clipped however narrow the window. */
final class ButtonPane extends JPanel {
    private static final long serialVersionUID = 1L;

    ButtonPane(List<FrameAction> actions, StopPanel stop) {
        super(new BorderLayout(8, 0));
        setBorder(BorderFactory.createEmptyBorder(6, 8, 6, 8));
        JPanel row = new JPanel(new MigLayout("insets 0, gap 2", "", "[fill]"));
        actions.forEach(action -> row.add(button(action), "h 52!, wmin 66"));
        add(row, BorderLayout.CENTER);
        add(stop, BorderLayout.EAST);
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
