package majic.panel;

/** A window that can show a camera picture larger. A {@link PictureView} looks for it among its parents and owners. */
public interface PictureViewer {
    /**
     * Opens a larger view of the same pictures; called on the event dispatch thread, returns at once.
     *
     * @param view the view to enlarge
     */
    void enlarge(PictureView view);
}
