package majic.gui.kit;

import javax.swing.JLabel;

/** A label with a name, under which tests find it. */
public class PlainLabel extends JLabel {
    private static final long serialVersionUID = 1L;

    public PlainLabel(String name, String text) {
        setName(name);
        setText(text);
    }
}
