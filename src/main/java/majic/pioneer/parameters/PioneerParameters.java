package majic.pioneer.parameters;

import java.util.List;
import java.util.function.Consumer;
import majic.bot.ParameterTable;
import majic.driver.ParameterTheme;
import majic.pioneer.state.Equipment;
import majic.pioneer.state.PoseOffset;
import majic.time.TimeSource;

/**
 * The parameters of a Pioneer besides those that every robot has, theme by theme in the order in which people read them.
 *
 * <p>One rule for what is missing: what the model or the CONFIG packet says a robot does not have is not described, so a
 * script that asks for it is refused before anything drives. What only its readings can show, or a packet that it may not
 * send, is described and {@code unknown} with the reason.
 */
public final class PioneerParameters {
    private final ParameterTable table;
    private final List<ParameterTheme<Equipment>> themes;

    public PioneerParameters(ParameterTable table, List<ParameterTheme<Equipment>> themes) {
        this.table = table;
        this.themes = List.copyOf(themes);
    }

    /** All themes there are. */
    public static List<ParameterTheme<Equipment>> themes(
            PioneerAccess access, TimeSource time, PoseOffset placement, RampParameters pace, Consumer<String> notice) {
        PowerSwitches switches = new PowerSwitches(access, notice);
        return List.of(
                new PoseParameters(access, placement),
                pace,
                new HealthParameters(access, switches),
                new PowerParameters(access),
                new ContactParameters(access),
                new SonarParameters(access, switches),
                new SensorParameters(access),
                new GripperParameters(access),
                new InputOutputParameters(access),
                new BuzzerParameters(access, time),
                new JoystickParameters(access),
                new IdentityParameters(access),
                new LinkParameters(access));
    }

    /** Describes what a robot with this equipment has, and nothing else. */
    public void describe(Equipment equipment) {
        table.renew(fresh -> themes.forEach(theme -> theme.describe(fresh, equipment)));
    }

    /** Ends what setting one of them has made the robot do. */
    public void halt() {
        themes.forEach(ParameterTheme::halt);
    }
}
