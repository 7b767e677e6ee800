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
 * @param model the model, with the sonars that this robot has
 * @param sonars whether there may be any
 * @param bumpers the segments it has
 * @param gripper whether there may be one
 * @param charger whether there may be a docking charger
 * @param gyro whether there may be one that the client reads
 * @param limits of speed and acceleration
 */
public record Equipment(
        Model model, boolean sonars, Bumpers bumpers, boolean gripper, boolean charger, boolean gyro, Limits limits) {
    /** As many as FLAGS has bits for (ARCOS sheet 8.1). */
    static final int SONAR_ARRAYS = 4;

    /** Sonar discs of one array (ARCOS sheet 8.1, 12). */
    static final int DISCS_OF_AN_ARRAY = 8;

    public static Equipment of(Model model, @Nullable Config config) {
        boolean front = mayHave(config, ConfigField.FRONTSONAR);
        boolean rear = mayHave(config, ConfigField.REARSONAR);
        return new Equipment(
                front && rear ? model : model.with(fitted(model, front, rear)),
                front || rear,
                Bumpers.of(model, config),
                mayHave(config, ConfigField.GRIPPER),
                mayHave(config, ConfigField.CHARGER),
                mayHave(config, ConfigField.HASGYRO) && (config == null || config.number(ConfigField.HASGYRO) <= 1),
                Limits.of(model, config));
    }

    private static boolean mayHave(@Nullable Config config, ConfigField field) {
        return config == null || config.mayHave(field);
    }

    /** The discs of whole arrays: a robot has those that look ahead, those that look back, or none of them. */
    private static List<SonarDisc> fitted(Model model, boolean front, boolean rear) {
        return model.discs().stream()
                .filter(disc -> looksAhead(model, disc.array()) ? front : rear)
                .toList();
    }

    private static boolean looksAhead(Model model, int array) {
        return model.discs().stream()
                        .filter(disc -> disc.array() == array)
                        .mapToDouble(disc -> Math.cos(Math.toRadians(disc.axisDeg())))
                        .sum()
                >= 0;
    }

    /** The numbers of the sonar discs; of an unknown model all possible ones. */
    public List<Integer> discs() {
        return model.known() || !sonars
                ? model.discs().stream().map(SonarDisc::number).toList()
                : IntStream.range(0, SonarScan.DISCS).boxed().toList();
    }

    /** The numbers of the sonar arrays, 1 to 4; array 1 has the discs 0 to 7. */
    public List<Integer> sonarArrays() {
        return model.discs().stream().map(SonarDisc::array).distinct().sorted().toList();
    }
}
