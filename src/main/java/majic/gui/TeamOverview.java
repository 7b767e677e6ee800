package majic.gui;

import com.formdev.flatlaf.util.UIScale;
import java.awt.BorderLayout;
import javax.swing.JComponent;
import javax.swing.JPanel;

/** The cards and the map beside each other; where there is no room for a map that can be read, the cards alone. */
final class TeamOverview extends JPanel {
    private static final long serialVersionUID = 1L;
    private static final int GAP = 6;

    /** Width in pixels of the narrowest map. */
    private static final int LEAST_MAP = 120;

    private final JComponent cards;
    private final JComponent map;

    TeamOverview(JComponent cards, JComponent map) {
        super(new BorderLayout(GAP, 0));
        this.cards = cards;
        this.map = map;
        add(cards, BorderLayout.WEST);
        add(map, BorderLayout.CENTER);
    }

    @Override
    public void doLayout() {
        int beside = cards.isVisible() ? cards.getPreferredSize().width + GAP : 0;
        map.setVisible(getWidth() - beside >= UIScale.scale(LEAST_MAP));
        super.doLayout();
        if (!map.isVisible()) {
            cards.setSize(getWidth(), getHeight());
        }
    }
}
