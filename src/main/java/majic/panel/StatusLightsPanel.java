package majic.panel;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Dimension;
import java.awt.FontMetrics;
import java.util.List;
import javax.swing.JPanel;

/**
 * Shows status lights in rows, two beside each other where there is enough width. None is ever left out; the last one
 * takes the rest of its row. Must be used on the event dispatch thread.
 */
public final class StatusLightsPanel extends JPanel {
    private static final long serialVersionUID = 1;
    private static final int GAP = 6;
    private static final int SLACK = 4;

    private final transient List<StatusLight> lights;
    private final transient List<String> widest;

    /**
     * Creates a panel of lights in the order of reading.
     *
     * @param longest the longest text of a light, which determines the width
     * @param lights all lights
     */
    public StatusLightsPanel(String longest, List<StatusLight> lights) {
        this(List.of(longest), lights);
    }

    /**
     * Creates a panel of lights in the order of reading.
     *
     * @param widest texts of lights, the widest of which determines the width
     * @param lights all lights
     */
    public StatusLightsPanel(List<String> widest, List<StatusLight> lights) {
        super(null);
        this.widest = List.copyOf(widest);
        this.lights = List.copyOf(lights);
        setOpaque(false);
        lights.forEach(this::add);
    }

    /**
     * Shows whether the conditions are current; older ones are greyed.
     *
     * @param current whether they are current
     */
    public void setCurrent(boolean current) {
        lights.forEach(light -> light.setEnabled(current));
    }

    /** Returns the minimum width. */
    int widthOf(int sideBySide) {
        return sideBySide * (lightWidth() + GAP) - GAP;
    }

    /** Returns the height needed. */
    int heightIn(int width) {
        return rowHeight() * ((lights.size() + columnsIn(width) - 1) / columnsIn(width));
    }

    private int columnsIn(int width) {
        return width < widthOf(2) ? 1 : 2;
    }

    @Override
    public void doLayout() {
        int columns = columnsIn(getWidth());
        int width = (getWidth() + GAP) / columns;
        for (int index = 0; index < lights.size(); index++) {
            int x = index % columns * width;
            boolean last = index == lights.size() - 1;
            lights.get(index)
                    .setBounds(x, index / columns * rowHeight(), last ? getWidth() - x : width - GAP, rowHeight());
        }
    }

    @Override
    public Dimension getPreferredSize() {
        return new Dimension(widthOf(1), heightIn(widthOf(1)));
    }

    private int lightWidth() {
        StatusLight light = lights.get(0);
        return light.getIcon().getIconWidth()
                + UIScale.scale(light.getIconTextGap())
                + widest.stream().mapToInt(metrics()::stringWidth).max().orElse(0)
                + UIScale.scale(SLACK);
    }

    private int rowHeight() {
        return metrics().getHeight() + 1;
    }

    private FontMetrics metrics() {
        return getFontMetrics(lights.get(0).getFont());
    }
}
