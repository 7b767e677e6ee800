package majic.gui.bots;

import java.awt.event.KeyEvent;
import javax.swing.BorderFactory;
import javax.swing.JScrollPane;
import javax.swing.KeyStroke;

/** Scrolls the team strip of a large team. Visible while the strip is. */
public final class StripScroll extends JScrollPane {
    private static final long serialVersionUID = 1L;

    /** Creates it around a strip. */
    public StripScroll(TeamStrip strip) {
        super(strip, VERTICAL_SCROLLBAR_AS_NEEDED, HORIZONTAL_SCROLLBAR_NEVER);
        setName("teamStripScroll");
        setBorder(BorderFactory.createEmptyBorder());
        setVisible(strip.isVisible());
    }

    /** Leaves the arrow keys to the strip, which selects robots with them. */
    @Override
    protected boolean processKeyBinding(KeyStroke stroke, KeyEvent event, int condition, boolean pressed) {
        return false;
    }
}
