package majic.figures;

import java.awt.AWTException;
import java.awt.Robot;
import java.awt.event.KeyEvent;
import java.io.IOException;
import java.nio.file.Path;

/**
 * Presses F12 from a program of its own, as a keyboard does: over another connection with the display than that on
 * which the measured window draws. A key that the window's own program presses waits until nothing is being drawn.
 */
final class KeyProgram implements AutoCloseable {
    private static final String JAVA =
            Path.of(System.getProperty("java.home"), "bin", "java").toString();

    private final Process process;

    private KeyProgram(Process process) {
        this.process = process;
    }

    /** Returns when the program can press keys. */
    static KeyProgram start() throws IOException {
        Process process = new ProcessBuilder(
                        JAVA, "-cp", System.getProperty("java.class.path"), KeyProgram.class.getName())
                .redirectError(ProcessBuilder.Redirect.INHERIT)
                .start();
        if (process.getInputStream().read() < 0) {
            throw new IOException("no key can be pressed");
        }
        return new KeyProgram(process);
    }

    /** Presses and releases the key, a moment after this method has returned. */
    void press() throws IOException {
        process.getOutputStream().write('\n');
        process.getOutputStream().flush();
    }

    @Override
    public void close() {
        process.destroyForcibly();
    }

    /** Presses the key for each byte of the standard input. The key before the first one loads what all need. */
    public static void main(String[] arguments) throws AWTException, IOException {
        Robot keys = new Robot();
        press(keys, KeyEvent.VK_SHIFT);
        System.out.println("ready");
        System.out.flush();
        while (System.in.read() >= 0) {
            press(keys, KeyEvent.VK_F12);
        }
    }

    private static void press(Robot keys, int key) {
        keys.keyPress(key);
        keys.keyRelease(key);
    }
}
