package majic.panel;

/**
 * A component whose parts are side by side where there is enough width, and one below the other where there is not.
 * Must be used on the event dispatch thread.
 */
public interface FoldingPane {
    /** Returns the minimum width, with one part below the other, pixels. */
    int foldedWidth();

    /** Returns the minimum width with parts side by side, pixels. */
    int unfoldedWidth();

    /**
     * Returns the height that it needs.
     *
     * @param width its width, pixels
     * @return pixels
     */
    int heightIn(int width);
}
