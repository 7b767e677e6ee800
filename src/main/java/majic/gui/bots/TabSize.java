package majic.gui.bots;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Component;

/** How much a robot's tab shows. */
enum TabSize {
    /** Three lines: name, condition, activity, with the words of the buttons. */
    FULL(3, 16, 220),
    /** Two lines: name, and the most important of the others. */
    MEDIUM(2, 12, 220),
    /** Two lines of half the width; the most important of the others beside connection and battery. */
    SMALL(2, 6, 124),
    /** One line: the most important; connection and battery only in words, if they need attention. */
    NARROW(1, 10, 84),
    /** The number and the sign of the state, without buttons. */
    BADGE(1, 5, 45);

    private final int lines;
    private final int extra;
    private final int width;

    TabSize(int lines, int extra, int width) {
        this.lines = lines;
        this.extra = extra;
        this.width = width;
    }

    /** Returns the height in pixels that a tab of this size needs in the font of a component. */
    int height(Component component) {
        int line = component.getFontMetrics(component.getFont()).getHeight();
        return lines * line + UIScale.scale(extra);
    }

    /** Returns the width in pixels that a tab of this size needs. */
    int width() {
        return UIScale.scale(width);
    }
}
