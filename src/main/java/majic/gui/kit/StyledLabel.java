package majic.gui.kit;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Font;
import javax.swing.UIManager;

/**
 * A label in another style or size than usual, which follow the look and feel. FlatLaf can style any component by a
 * client property, but reads annotations for it and installs the look of the component twice, which delays the first
 * window.
 */
public final class StyledLabel extends NamedLabel {
    private static final long serialVersionUID = 1L;

    private final int style;
    private final float larger;

    /**
     * Creates a label.
     *
     * @param style one of the styles of {@link Font}, such as {@link Font#BOLD}
     * @param larger points by which the text is larger than usual, at the usual text size; negative if smaller
     */
    public StyledLabel(String name, String text, int style, float larger) {
        super(name, text);
        this.style = style;
        this.larger = larger;
        chooseFont();
    }

    @Override
    public void updateUI() {
        super.updateUI();
        chooseFont();
    }

    private void chooseFont() {
        Font usual = UIManager.getFont("Label.font");
        if (usual != null) {
            setFont(usual.deriveFont(style, usual.getSize2D() + UIScale.scale(larger)));
        }
    }
}
