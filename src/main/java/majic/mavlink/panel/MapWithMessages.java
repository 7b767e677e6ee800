package majic.mavlink.panel;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Rectangle;
import javax.swing.JComponent;
import javax.swing.JPanel;

/**
 * A map with the messages below it, which are left out where the map would become too low, or where they would be too
 * narrow. For the event dispatch thread.
 */
final class MapWithMessages extends JPanel {
    private static final long serialVersionUID = 1;
    private static final int GAP = 4;

    /** The map is at least so high, pixels. */
    private static final int LEAST_MAP = 150;

    /** Messages are not readable in less, pixels. */
    private static final int LEAST_WIDTH = 220;

    /** More height than this share is not taken from the map. */
    private static final double SHARE = 0.3;

    private final JComponent map;
    private final JComponent messages;

    MapWithMessages(JComponent map, JComponent messages) {
        super(null);
        this.map = map;
        this.messages = messages;
        setOpaque(false);
        add(map);
        add(messages);
    }

    @Override
    public void doLayout() {
        int gap = UIScale.scale(GAP);
        int good = messages.getPreferredSize().height;
        int height = Math.max(good, (int) (SHARE * getHeight()));
        boolean fits = getWidth() >= UIScale.scale(LEAST_WIDTH) && getHeight() - good - gap >= UIScale.scale(LEAST_MAP);
        Rectangle room = new Rectangle(0, 0, getWidth(), getHeight());
        messages.setVisible(fits);
        if (fits) {
            int below = Math.min(height, getHeight() - gap - UIScale.scale(LEAST_MAP));
            messages.setBounds(0, getHeight() - below, getWidth(), below);
            room.height -= below + gap;
        }
        map.setBounds(room);
    }
}
