package majicsim.pioneer.model;

import java.util.Arrays;
import java.util.Locale;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;

/** What is different from the plain model, named behind the model's name: {@code p3dx-sh+gripper+nowatchdog}. */
enum Extra {
    GRIPPER(model -> model.with(model.equipment().withGripper())),
    GYRO(model -> model.with(model.equipment().withGyro())),
    CHARGER(model -> model.with(model.equipment().withCharger())),
    COMPASS(model -> model.with(model.equipment().withCompass())),
    LASER(model -> model.with(model.equipment().withLaser())),
    BUMPERS(PioneerModel::withBumpers),
    NOFRONTSONAR(model -> model.withoutSonars(true)),
    NOREARSONAR(model -> model.withoutSonars(false)),
    NOWATCHDOG(PioneerModel::withoutWatchdog),
    UNLISTED(PioneerModel::unlisted);

    private final UnaryOperator<PioneerModel> fitting;

    Extra(UnaryOperator<PioneerModel> fitting) {
        this.fitting = fitting;
    }

    PioneerModel fitTo(PioneerModel model) {
        return fitting.apply(model);
    }

    /**
     * The extra of this name, without regard to case.
     *
     * @throws IllegalArgumentException if there is none; the message lists the valid names
     */
    static Extra named(String name) {
        return Arrays.stream(values())
                .filter(extra -> extra.name().equalsIgnoreCase(name))
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException(
                        String.format(Locale.ROOT, "a Pioneer has no extra '%s'; known are %s", name, known())));
    }

    private static String known() {
        return Arrays.stream(values())
                .map(extra -> extra.name().toLowerCase(Locale.ROOT))
                .collect(Collectors.joining(", "));
    }
}
