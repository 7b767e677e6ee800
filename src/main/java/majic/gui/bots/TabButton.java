package majic.gui.bots;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Insets;
import javax.swing.Icon;
import javax.swing.JButton;

/** A small button on a robot's tab, which shows its word only where there is room. */
final class TabButton extends JButton {
    private static final long serialVersionUID = 1L;
    private static final int MARGIN = 5;
    private static final int NARROW_MARGIN = 2;

    private final String word;

    TabButton(String name, String word, Icon icon, String tip) {
        super(icon);
        this.word = word;
        setName(name);
        setFocusable(false);
        setIconTextGap(UIScale.scale(3));
        setToolTipText(tip);
        getAccessibleContext().setAccessibleName(tip);
    }

    /** Adapts the button to the size of its tab. */
    void show(TabSize size) {
        setText(size == TabSize.FULL ? word : "");
        int side = size == TabSize.FULL || size == TabSize.MEDIUM ? MARGIN : NARROW_MARGIN;
        setMargin(new Insets(1, side, 1, side));
    }
}
