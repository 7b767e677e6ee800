package majic.aibo.parameters;

import java.util.List;
import majic.aibo.body.DogState;
import majic.aibo.session.JointControl;
import majic.aibo.sound.Volume;
import majic.aibo.urbi.UrbiVersion;
import majic.bot.ParameterTable;
import majic.driver.ParameterTheme;

/**
 * The parameters of an Aibo besides those that every robot has, theme by theme in the order in which people read them.
 * Distances are in mm, angles in degrees. Before a dog was met they are those of URBI 1.0.
 */
public final class AiboParameters {
    private final ParameterTable table;
    private final List<ParameterTheme<UrbiVersion>> themes;

    public AiboParameters(ParameterTable table, DogState dog, AiboAccess access, Volume volume) {
        this.table = table;
        JointControl jointControl = new JointControl(dog.senses(), access::open);
        this.themes = List.of(
                new RangeParameters(dog),
                new BodyParameters(access),
                new SenseParameters(access),
                new JointParameters(access, jointControl),
                new LoadParameters(access, jointControl),
                new EarParameters(access, jointControl),
                new LightParameters(access),
                new CameraParameters(access),
                new SoundParameters(access, volume));
    }

    /** Describes what a dog with a stick of this generation has. */
    public void describe(UrbiVersion version) {
        table.renew(fresh -> themes.forEach(theme -> theme.describe(fresh, version)));
    }
}
