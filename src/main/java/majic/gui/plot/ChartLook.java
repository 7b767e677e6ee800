package majic.gui.plot;

import com.formdev.flatlaf.FlatLaf;
import java.awt.Color;
import java.awt.Font;
import javax.swing.UIManager;
import majic.panel.DrawingColors;

/**
 * Colours and font of a chart, so that it can be painted on another thread. Immutable.
 *
 * @param dark whether the background is dark
 * @param paper the background
 * @param text colour of texts
 * @param grid colour of the lines of the grid
 * @param frame colour of the frame and of marks
 * @param font font of all texts
 */
record ChartLook(boolean dark, Color paper, Color text, Color grid, Color frame, Font font) {
    private static final float SMALLER = 0.92f;

    /** Returns the colours of the present look and feel; on the event dispatch thread. */
    static ChartLook current() {
        DrawingColors colors = DrawingColors.current();
        Font font = UIManager.getFont("Label.font");
        return new ChartLook(
                FlatLaf.isLafDark(),
                colors.paper(),
                colors.grey(0.85),
                colors.grey(0.13),
                colors.grey(0.45),
                font.deriveFont(font.getSize2D() * SMALLER));
    }
}
