package majic.gui.kit;

/** Text of others in labels that understand HTML. */
public final class Html {
    private Html() {}

    /** The same text, with nothing in it that a label would take for a tag. */
    public static String escaped(String text) {
        return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;");
    }
}
