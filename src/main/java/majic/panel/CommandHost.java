package majic.panel;

import java.util.Optional;
import javax.swing.JComponent;
import javax.swing.SwingUtilities;

/**
 * Submits the commands of the controls in the panel of one robot. Implemented by a container of the panel of a robot of
 * the team; the panel of a recorded robot has none. Must be used on the event dispatch thread.
 */
public interface CommandHost {
    /**
     * Submits a command for the robot as if it had been typed; returns at once.
     *
     * @param command in MAJIC Script, without the number of the robot: {@code set mode HOLD}
     */
    void submitCommand(String command);

    /**
     * Returns the host of a component.
     *
     * @param component part of a robot's panel
     * @return empty where no commands can be submitted
     */
    static Optional<CommandHost> of(JComponent component) {
        return Optional.ofNullable((CommandHost) SwingUtilities.getAncestorOfClass(CommandHost.class, component));
    }
}
