package majic.gui.kit;

import javax.swing.JLabel;

/** A label for text from outside, such as a file's author; never interprets it as HTML. */
public class PlainLabel extends JLabel {
    private static final long serialVersionUID = 1L;

    public PlainLabel(String name, String text) {
        setName(name);
        putClientProperty("html.disable", Boolean.TRUE);
        setText(text);
    }
}
