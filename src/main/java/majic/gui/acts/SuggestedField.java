package majic.gui.acts;

import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import javax.swing.JTextField;

/** A text field that shows a suggestion until another text is entered. */
final class SuggestedField extends JTextField {
    private static final long serialVersionUID = 1L;

    private String suggestion = "";

    SuggestedField(String name) {
        setName(name);
    }

    /** Shows a suggestion, unless another text was entered. */
    void suggest(String text) {
        if (getText().equals(suggestion)) {
            setText(text);
        }
        suggestion = text;
    }

    /** Runs an action whenever the field has lost the focus. */
    void whenFocusIsLost(Runnable action) {
        addFocusListener(new FocusAdapter() {
            @Override
            public void focusLost(FocusEvent event) {
                action.run();
            }
        });
    }
}
