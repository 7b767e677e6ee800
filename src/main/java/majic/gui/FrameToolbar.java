package majic.gui;

import com.formdev.flatlaf.util.UIScale;
import java.awt.BorderLayout;
import java.awt.Dimension;
import java.util.List;
import javax.swing.BorderFactory;
import javax.swing.Box;
import javax.swing.JButton;
import javax.swing.JPanel;
import javax.swing.SwingConstants;
import majic.gui.kit.IconAction;

/**
 * Places the row of buttons at the top, with STOP at its end. STOP is never clipped, however narrow the window is.
 * Where there is too little room for all texts beside Release, the buttons show their icons alone, whether STOP is
 * latched or not, so that no button moves when it is.
 */
final class FrameToolbar extends JPanel {
    private static final long serialVersionUID = 1L;

    /** Height of the buttons at the normal font size, pixels. */
    static final int BUTTON_HEIGHT = 52;

    private static final int LEAST_BUTTON_WIDTH = 48;
    private static final int GAP = 8;

    private final Box row = Box.createHorizontalBox();
    private final transient List<JButton> buttons;
    private final StopPanel stop;
    private int wordsWidth;

    /**
     * Places the buttons.
     *
     * @param buttons made by {@link #button}, in their order
     */
    FrameToolbar(List<JButton> buttons, StopPanel stop) {
        super(new BorderLayout(GAP, 0));
        this.stop = stop;
        this.buttons = List.copyOf(buttons);
        setBorder(BorderFactory.createEmptyBorder(6, GAP, 6, GAP));
        buttons.forEach(row::add);
        add(row, BorderLayout.CENTER);
        add(stop, BorderLayout.EAST);
    }

    @Override
    public void doLayout() {
        if (!buttons.get(0).getHideActionText()) {
            wordsWidth = row.getPreferredSize().width;
        }
        boolean fits = wordsWidth <= getWidth() - 3 * GAP - stop.widestWidth();
        buttons.forEach(button -> button.setHideActionText(!fits));
        super.doLayout();
    }

    /** Makes the button of an action. */
    static JButton button(IconAction action) {
        JButton button = new ToolbarButton(action);
        button.setName((String) action.getValue(IconAction.NAME));
        button.setVerticalTextPosition(SwingConstants.BOTTOM);
        button.setHorizontalTextPosition(SwingConstants.CENTER);
        button.setFocusable(false);
        button.putClientProperty("JButton.buttonType", "toolBarButton");
        return button;
    }

    /** A button as high as STOP, so that its whole height can be clicked. */
    private static final class ToolbarButton extends JButton {
        private static final long serialVersionUID = 1L;

        ToolbarButton(IconAction action) {
            super(action);
        }

        @Override
        public Dimension getPreferredSize() {
            int width = Math.max(super.getPreferredSize().width, UIScale.scale(LEAST_BUTTON_WIDTH));
            return new Dimension(width, UIScale.scale(BUTTON_HEIGHT));
        }

        @Override
        public Dimension getMaximumSize() {
            return getPreferredSize();
        }
    }
}
