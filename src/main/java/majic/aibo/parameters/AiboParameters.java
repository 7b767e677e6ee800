package majic.aibo.parameters;

import java.util.List;
import majic.aibo.body.DogState;
import majic.aibo.sound.Volume;
import majic.aibo.urbi.UrbiVersion;
import majic.driver.ParameterTable;
import majic.driver.ParameterTheme;

/**
 * The parameters of an Aibo besides those that every robot has, theme by theme. Distances are in mm, angles in degrees.
 * Before the first connection they are those of URBI 1.0.
 */
public final class AiboParameters {
    private final ParameterTable table;
    private final List<ParameterTheme<UrbiVersion>> themes;

    public AiboParameters(ParameterTable table, DogState dog, AiboAccess access, Volume volume) {
        this.table = table;
        SensorValueParameters sensors = new SensorValueParameters(access, dog);
        this.themes = List.of(
                sensors::ranges,
                new BodyParameters(access),
                sensors::others,
                new JointParameters(access, dog),
                new EarParameters(access),
                new LedParameters(access),
                new CameraParameters(access),
                new SoundParameters(access, volume));
    }

    /** Describes what a dog with a stick of this generation has. */
    public void describe(UrbiVersion version) {
        table.renew(fresh -> themes.forEach(theme -> theme.describe(fresh, version)));
    }
}
