package majic.gui.kit;

import javax.swing.JLabel;

/** A label for the words of others, such as a file's author: it never takes them for HTML. */
public final class PlainLabel extends JLabel {
    private static final long serialVersionUID = 1L;

    public PlainLabel(String name, String text) {
        setName(name);
        putClientProperty("html.disable", Boolean.TRUE);
        setText(text);
    }
}
