package majic.gui.bots;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Component;

/** How much a robot's card shows. */
enum CardSize {
    /** Three lines: name, condition, activity. */
    FULL(3, 16),
    /** Two lines: name, and the most important of the others. */
    MEDIUM(2, 12),
    /** One line. */
    COMPACT(1, 10),
    /** One line of half the width; battery and connection only if they need attention. */
    NARROW(1, 10),
    /** The number and the sign of the state, without buttons. */
    BADGE(1, 5);

    private final int lines;
    private final int extra;

    CardSize(int lines, int extra) {
        this.lines = lines;
        this.extra = extra;
    }

    /** Returns the height in pixels that a card of this size needs in the font of a component. */
    int height(Component component) {
        int line = component.getFontMetrics(component.getFont()).getHeight();
        return lines * line + UIScale.scale(extra);
    }
}
