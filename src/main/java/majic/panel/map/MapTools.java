package majic.panel.map;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Insets;
import java.util.EnumMap;
import java.util.Map;
import javax.swing.AbstractButton;
import javax.swing.BorderFactory;
import javax.swing.Box;
import javax.swing.BoxLayout;
import javax.swing.JButton;
import javax.swing.JPanel;
import javax.swing.JToggleButton;
import majic.panel.DrawingColors;

/** Holds the buttons in a map's corner. */
final class MapTools extends JPanel {
    private static final long serialVersionUID = 1;
    private static final int GAP_PX = 6;

    private final transient ZoomableMap map;
    private final transient Map<MapAction, AbstractButton> toggles = new EnumMap<>(MapAction.class);

    MapTools(ZoomableMap map) {
        setLayout(new BoxLayout(this, BoxLayout.X_AXIS));
        setBorder(BorderFactory.createEmptyBorder(1, 1, 1, 1));
        this.map = map;
        setOpaque(false);
        for (MapAction action : MapAction.WITH_BUTTON) {
            if (action.suits(map)) {
                addButton(action);
            }
        }
        showState();
    }

    private void addButton(MapAction action) {
        AbstractButton button = action.toggles() ? new JToggleButton() : new JButton();
        button.setName("map " + action.name().toLowerCase(java.util.Locale.ROOT));
        button.setIcon(action);
        button.setMargin(new Insets(3, 3, 3, 3));
        button.putClientProperty("JButton.buttonType", "toolBarButton");
        button.setToolTipText(action.tip());
        button.getAccessibleContext().setAccessibleName(action.title());
        button.addActionListener(pressed -> action.perform(map));
        if (action.toggles()) {
            toggles.put(action, button);
        }
        if (action == MapAction.CLEAR) {
            add(Box.createHorizontalStrut(UIScale.scale(GAP_PX)));
        }
        add(button);
    }

    /** Selects the buttons that match the map's state. */
    void showState() {
        toggles.forEach((action, button) -> button.setSelected(action.isOn(map)));
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D pen = (Graphics2D) graphics.create();
        DrawingColors.prepare(pen);
        pen.setColor(DrawingColors.translucent(ZoomableMap.floor(), 0.8));
        pen.fillRoundRect(0, 0, getWidth(), getHeight(), 8, 8);
        pen.dispose();
    }
}
