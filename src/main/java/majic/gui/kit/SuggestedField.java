package majic.gui.kit;

import javax.swing.JTextField;

/** A text field that shows a suggestion until another text is entered. */
public final class SuggestedField extends JTextField {
    private static final long serialVersionUID = 1L;

    private String suggestion = "";

    public SuggestedField(String name) {
        setName(name);
    }

    /** Shows a suggestion, unless another text was entered. */
    public void suggest(String text) {
        if (getText().equals(suggestion)) {
            setText(text);
        }
        suggestion = text;
    }
}
