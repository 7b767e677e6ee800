package majic.gui.kit;

/** Escapes text for labels that interpret HTML. */
public final class Html {
    private Html() {}

    /** Returns the text with all characters escaped that a label would interpret as a tag. */
    public static String escaped(String text) {
        return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;");
    }
}
