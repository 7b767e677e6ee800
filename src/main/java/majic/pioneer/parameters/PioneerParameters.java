package majic.pioneer.parameters;

import java.util.List;
import majic.driver.BotDriver;
import majic.driver.ParameterTable;
import majic.driver.ParameterTheme;
import majic.pioneer.state.Equipment;

/**
 * The parameters of a Pioneer besides those that every robot has, theme by theme in the order of the listing.
 *
 * <p>Parameters of equipment that a robot does not have by its model or its CONFIG packet are not described, so a
 * script that uses them is refused before anything moves. Parameters whose values depend on readings, or on packets
 * that not every robot sends, are described and {@code unknown} with the reason.
 */
public final class PioneerParameters {
    private final ParameterTable table;
    private final List<ParameterTheme<Equipment>> themes;

    public PioneerParameters(ParameterTable table, List<ParameterTheme<Equipment>> themes) {
        this.table = table;
        this.themes = List.copyOf(themes);
    }

    /** All themes. */
    public static List<ParameterTheme<Equipment>> themes(BotDriver bot, PioneerAccess access, RampParameters pace) {
        ReportedParameters reported = new ReportedParameters(access);
        return List.of(
                new PoseParameters(access, () -> bot.state().pose(), bot::place),
                pace,
                reported::power,
                new ContactParameters(access),
                new SonarParameters(access),
                new LaserParameters(access),
                reported::motion,
                new GripperParameters(access),
                new InputOutputParameters(access),
                new BuzzerParameters(access, bot.time()),
                new JoystickParameters(access),
                reported::identity,
                reported::link);
    }

    /** Describes what a robot with this equipment has, and nothing else. */
    public void describe(Equipment equipment) {
        table.renew(fresh -> themes.forEach(theme -> theme.describe(fresh, equipment)));
    }

    /** Ends what setting a parameter has started. */
    public void halt() {
        themes.forEach(ParameterTheme::halt);
    }
}
