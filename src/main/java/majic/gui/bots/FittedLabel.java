package majic.gui.bots;

import java.awt.Dimension;
import java.awt.FontMetrics;
import java.awt.Insets;
import java.util.List;
import majic.gui.kit.NamedLabel;

/** A label that shows the longest of some wordings for which it has room, and shortens the last one if it has not. */
final class FittedLabel extends NamedLabel {
    private static final long serialVersionUID = 1L;

    private transient List<String> wordings = List.of("");

    FittedLabel(String name) {
        super(name, "");
    }

    /**
     * Sets the text.
     *
     * @param newWordings from the longest to the shortest, at least one; an empty last one leaves the icon alone
     */
    void setWordings(List<String> newWordings) {
        wordings = List.copyOf(newWordings);
        fit();
    }

    @Override
    public void setBounds(int x, int y, int width, int height) {
        super.setBounds(x, y, width, height);
        fit();
    }

    private void fit() {
        setText(wordings.stream()
                .filter(text -> width(text) <= getWidth())
                .findFirst()
                .orElse(wordings.get(wordings.size() - 1)));
    }

    private int width(String text) {
        FontMetrics metrics = getFontMetrics(getFont());
        Insets insets = getInsets();
        int icon = getIcon() == null ? 0 : getIcon().getIconWidth() + getIconTextGap();
        return metrics.stringWidth(text) + icon + insets.left + insets.right;
    }

    /** Returns the size for the longest wording, so that what the label shows does not change the layout. */
    @Override
    public Dimension getPreferredSize() {
        Dimension size = super.getPreferredSize();
        return wordings == null ? size : new Dimension(width(wordings.get(0)), size.height);
    }
}
