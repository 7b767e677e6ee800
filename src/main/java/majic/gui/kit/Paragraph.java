package majic.gui.kit;

import javax.swing.JTextArea;
import javax.swing.UIManager;

/** Words that break into lines as wide as there is room, and that can be copied but not changed. */
public final class Paragraph extends JTextArea {
    private static final long serialVersionUID = 1L;

    /**
     * An empty one.
     *
     * @param columns how wide it would like to be, in characters
     */
    public Paragraph(String name, int rows, int columns) {
        super(rows, columns);
        setName(name);
        setEditable(false);
        setLineWrap(true);
        setWrapStyleWord(true);
        setOpaque(false);
        setFocusable(false);
        setBorder(null);
        setFont(UIManager.getFont("Label.font"));
    }

    /** Shows words, in the colour of errors or not. */
    public void show(String words, boolean wrong) {
        setForeground(wrong ? Palette.error() : Palette.text());
        setText(words);
    }
}
