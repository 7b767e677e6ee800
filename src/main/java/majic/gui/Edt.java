package majic.gui;

import javax.swing.SwingUtilities;

/** The one way onto the event dispatch thread, and the one way off it. */
final class Edt {
    private Edt() {}

    /** Does something to the window soon; callable from any thread, keeps the order of one caller. */
    static void later(Runnable change) {
        SwingUtilities.invokeLater(change);
    }

    /**
     * Does something that may wait, such as talking to a robot, on a daemon thread of its own.
     *
     * @param name what a thread dump shows
     * @param work handles its own failures
     */
    static void background(String name, Runnable work) {
        Thread thread = new Thread(work, name);
        thread.setDaemon(true);
        thread.start();
    }
}
