package majic.gui.kit;

import javax.swing.JTextArea;
import javax.swing.UIManager;

/** A text that is wrapped to the available width, and that can be copied but not edited. */
public final class Paragraph extends JTextArea {
    private static final long serialVersionUID = 1L;

    /**
     * Creates an empty one.
     *
     * @param columns preferred width, in characters
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

    /** Shows a text, in the error colour if it is an error. */
    public void show(String words, boolean wrong) {
        setForeground(wrong ? Palette.error() : Palette.text());
        setText(words);
    }
}
