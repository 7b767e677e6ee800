package majic.bot;

import java.util.Map;
import javax.swing.JComponent;

/**
 * The display of a robot that is fed from a recording. All methods but {@link #component()} are called on one thread,
 * which is not the event dispatch thread; the component refreshes itself as that of a connected robot does.
 */
public interface ReplayDisplay {
    /**
     * Returns the display.
     *
     * @return the same component at every call; on the event dispatch thread
     */
    JComponent component();

    /**
     * Forgets what was shown, because the replay continues at another time.
     */
    void reset();

    /**
     * Shows a recorded state. Called in the order of the recording, also for states too short to be seen.
     *
     * @param state what {@link MajicBot#displayState()} returned; names may be missing
     * @param nanos the time of the recording
     */
    void show(Map<String, String> state, long nanos);

    /**
     * Shows a picture of the camera.
     *
     * @param jpeg a JPEG file
     */
    default void showPicture(byte[] jpeg) {}
}
