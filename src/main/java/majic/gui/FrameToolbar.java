package majic.gui;

import java.awt.BorderLayout;
import java.util.List;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JPanel;
import javax.swing.SwingConstants;
import majic.gui.kit.IconAction;
import net.miginfocom.swing.MigLayout;

/**
 * Places the row of buttons at the top, with STOP at its end. STOP is never clipped, however narrow the window is.
 * Where there is too little room for all texts, the buttons show their icons alone.
 */
final class FrameToolbar extends JPanel {
    private static final long serialVersionUID = 1L;

    private static final int GAP = 8;

    private final JPanel row = new JPanel(new MigLayout("insets 0, gap 0", "", "[fill]"));
    private final transient List<JButton> buttons;
    private final StopPanel stop;
    private int wordsWidth;

    FrameToolbar(List<IconAction> actions, StopPanel stop) {
        super(new BorderLayout(GAP, 0));
        this.stop = stop;
        this.buttons = actions.stream().map(FrameToolbar::button).toList();
        setBorder(BorderFactory.createEmptyBorder(6, GAP, 6, GAP));
        buttons.forEach(button -> row.add(button, "h 52!, wmin 48"));
        add(row, BorderLayout.CENTER);
        add(stop, BorderLayout.EAST);
    }

    @Override
    public void doLayout() {
        if (!buttons.get(0).getHideActionText()) {
            wordsWidth = row.getPreferredSize().width;
        }
        boolean fits = wordsWidth <= getWidth() - 3 * GAP - stop.getPreferredSize().width;
        buttons.forEach(button -> button.setHideActionText(!fits));
        super.doLayout();
    }

    private static JButton button(IconAction action) {
        JButton button = new JButton(action);
        button.setName((String) action.getValue(IconAction.NAME));
        button.setVerticalTextPosition(SwingConstants.BOTTOM);
        button.setHorizontalTextPosition(SwingConstants.CENTER);
        button.setFocusable(false);
        button.putClientProperty("JButton.buttonType", "toolBarButton");
        return button;
    }
}
