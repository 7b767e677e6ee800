package majic.program;

import java.awt.AWTEvent;
import java.awt.Toolkit;
import java.awt.Window;
import java.awt.event.WindowEvent;
import java.awt.image.BufferedImage;
import javax.swing.JFrame;
import majic.Majic;

/**
 * Starts MAJIC without arguments, and ends as soon as its window is open and was painted once. What the window does
 * afterwards is not begun then, however busy the computer is.
 */
final class OpenedWindow {
    private OpenedWindow() {}

    public static void main(String[] args) {
        Toolkit.getDefaultToolkit().addAWTEventListener(OpenedWindow::endAtFirst, AWTEvent.WINDOW_EVENT_MASK);
        Majic.main(args);
    }

    /** Listeners of the toolkit are called before those of the window. */
    private static void endAtFirst(AWTEvent event) {
        if (event.getID() == WindowEvent.WINDOW_OPENED) {
            paint((JFrame) event.getSource());
            Runtime.getRuntime().halt(0);
        }
    }

    private static void paint(Window window) {
        BufferedImage picture = new BufferedImage(window.getWidth(), window.getHeight(), BufferedImage.TYPE_INT_RGB);
        window.paint(picture.createGraphics());
    }
}
