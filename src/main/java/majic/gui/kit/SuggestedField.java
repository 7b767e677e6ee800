package majic.gui.kit;

import javax.swing.JTextField;

/** A text field that follows a suggestion until the person writes something else. */
public final class SuggestedField extends JTextField {
    private static final long serialVersionUID = 1L;

    private String suggestion = "";

    public SuggestedField(String name) {
        setName(name);
    }

    /** Shows a text, unless the person has written another one. */
    public void suggest(String text) {
        if (getText().equals(suggestion)) {
            setText(text);
        }
        suggestion = text;
    }
}
