package majic.gui.kit;

import javax.swing.JLabel;

/** A label with a name, under which tests find it. */
public class NamedLabel extends JLabel {
    private static final long serialVersionUID = 1L;

    public NamedLabel(String name, String text) {
        setName(name);
        setText(text);
    }
}
