package majic.gui;

/** Text of others in labels that understand HTML. */
final class Html {
    private Html() {}

    /** The same text, with nothing in it that a label would take for a tag. */
    static String escaped(String text) {
        return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;");
    }
}
