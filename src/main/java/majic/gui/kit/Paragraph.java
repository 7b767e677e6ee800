package majic.gui.kit;

import java.awt.Color;
import java.awt.Dimension;
import java.util.function.Supplier;
import javax.swing.BorderFactory;
import javax.swing.JTextArea;
import javax.swing.UIManager;
import majic.text.ErrorWords;
import majic.text.Texts;

/** A text that is wrapped to the available width, and that can be copied but not edited. */
public final class Paragraph extends JTextArea {
    private static final long serialVersionUID = 1L;
    private static final Texts TEXTS = Texts.of(Paragraph.class);

    private transient Supplier<Color> color = Palette::text;

    /**
     * Creates an empty one.
     *
     * @param columns preferred width, in characters
     */
    public Paragraph(String name, int rows, int columns) {
        super(rows, columns);
        setName(name);
        getAccessibleContext().setAccessibleName(TEXTS.get("message"));
        setEditable(false);
        setLineWrap(true);
        setWrapStyleWord(true);
        setOpaque(false);
        setFocusable(false);
        setBorder(BorderFactory.createEmptyBorder());
        setFont(UIManager.getFont("Label.font"));
    }

    /** Shows a text; an error in the error colour, and in the language of the window as far as that is known. */
    public void show(String words, boolean wrong) {
        show(wrong ? ErrorWords.of(words) : words, wrong ? Palette::error : Palette::text);
    }

    /** Shows a secondary text. */
    public void showFaint(String words) {
        show(words, Palette::faint);
    }

    /** Keeps one colour in every look and feel, for texts that are set by {@link #setText}. */
    public void keepColor(Color always) {
        color = () -> always;
        setForeground(always);
    }

    private void show(String words, Supplier<Color> newColor) {
        color = newColor;
        setForeground(newColor.get());
        setText(words);
    }

    /** One row: the height of the text at the least width would make a dialog higher than the screen. */
    @Override
    public Dimension getMinimumSize() {
        return new Dimension(0, getRowHeight());
    }

    /** Updates the colour for the look and feel. */
    @Override
    public void updateUI() {
        super.updateUI();
        if (color != null) {
            setForeground(color.get());
        }
    }
}
