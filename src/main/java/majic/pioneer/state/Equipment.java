package majic.pioneer.state;

import java.util.List;
import java.util.stream.IntStream;
import majic.pioneer.arcos.Config;
import majic.pioneer.arcos.ConfigField;
import org.jspecify.annotations.Nullable;

/**
 * The equipment of one robot by its model and its CONFIG packet. Without a CONFIG packet any equipment is possible.
 * Immutable.
 *
 * @param model the model
 * @param bumpers the segments it has
 * @param gripper whether there may be one
 * @param charger whether there may be a docking charger
 * @param gyro whether there may be one that the client reads
 * @param limits of speed and acceleration
 */
public record Equipment(Model model, Bumpers bumpers, boolean gripper, boolean charger, boolean gyro, Limits limits) {
    /** As many as FLAGS has bits for (ARCOS sheet 8.1). */
    static final int SONAR_ARRAYS = 4;

    /** Sonar discs of one array (ARCOS sheet 8.1, 12). */
    static final int DISCS_OF_AN_ARRAY = 8;

    public static Equipment of(Model model, @Nullable Config config) {
        return new Equipment(
                model,
                Bumpers.of(model, config),
                mayHave(config, ConfigField.GRIPPER),
                mayHave(config, ConfigField.CHARGER),
                mayHave(config, ConfigField.HASGYRO) && (config == null || config.number(ConfigField.HASGYRO) <= 1),
                Limits.of(model, config));
    }

    private static boolean mayHave(@Nullable Config config, ConfigField field) {
        return config == null || !config.isKnown(field) || config.has(field);
    }

    /** The numbers of the sonar discs; of an unknown model all possible ones. */
    public List<Integer> discs() {
        return model.known()
                ? model.discs().stream().map(SonarDisc::number).toList()
                : IntStream.range(0, SonarScan.DISCS).boxed().toList();
    }

    /** The numbers of the sonar arrays, 1 to 4; array 1 has the discs 0 to 7. */
    public List<Integer> sonarArrays() {
        return model.discs().stream()
                .map(disc -> disc.number() / DISCS_OF_AN_ARRAY + 1)
                .distinct()
                .sorted()
                .toList();
    }
}
