package majicsim.pioneer.model;

import java.util.List;

/**
 * What distinguishes one kind of Pioneer from the others. Immutable.
 *
 * @param subclass its name in the handshake, such as {@code p3dx-sh}
 * @param className the class in the handshake, {@code Pioneer} for nearly all
 * @param frontMm from the turning centre to the front
 * @param rearMm from the turning centre to the rear
 * @param halfWidthMm from the turning centre to either side
 * @param topSpeedMmPerSec the fastest it drives
 * @param topTurnDegPerSec the fastest it turns
 * @param scaling the factors of its raw numbers
 * @param hasMove whether the controller has the command MOVE
 * @param frontBumpers bumper segments in front, 0 to 7
 * @param rearBumpers bumper segments behind, 0 to 7
 * @param sonars the discs that are fitted, by number
 * @param equipment its other equipment
 */
public record PioneerModel(
        String subclass,
        String className,
        double frontMm,
        double rearMm,
        double halfWidthMm,
        double topSpeedMmPerSec,
        double topTurnDegPerSec,
        Scaling scaling,
        boolean hasMove,
        int frontBumpers,
        int rearBumpers,
        List<SonarDisc> sonars,
        Equipment equipment) {
    private static final int FITTED_SEGMENTS = 5;

    /** Copies the list of discs. */
    public PioneerModel {
        sonars = List.copyOf(sonars);
    }

    /**
     * The model with the name of this subclass, with the extras that follow it behind plus signs, without regard to
     * case.
     *
     * @throws IllegalArgumentException if there is no such model or extra; the message lists the valid ones
     */
    public static PioneerModel of(String name) {
        String[] parts = name.split("\\+", -1);
        PioneerModel model = ModelTable.find(parts[0]);
        for (int i = 1; i < parts.length; i++) {
            model = Extra.named(parts[i]).fitTo(model);
        }
        return model;
    }

    /** The subclasses of all models, in the order of the table. */
    public static List<String> subclasses() {
        return ModelTable.subclasses();
    }

    public boolean hasSonarArray(int array) {
        return sonars.stream().anyMatch(disc -> disc.array() == array);
    }

    PioneerModel with(Equipment newEquipment) {
        return fitted(frontBumpers, rearBumpers, newEquipment);
    }

    /** With as many bumper segments as the vendor fits (ARCOS sheet 12), unless it has its own. */
    PioneerModel withBumpers() {
        return fitted(orFitted(frontBumpers), orFitted(rearBumpers), equipment);
    }

    private static int orFitted(int segments) {
        return segments == 0 ? FITTED_SEGMENTS : segments;
    }

    private PioneerModel fitted(int newFrontBumpers, int newRearBumpers, Equipment newEquipment) {
        return new PioneerModel(
                subclass,
                className,
                frontMm,
                rearMm,
                halfWidthMm,
                topSpeedMmPerSec,
                topTurnDegPerSec,
                scaling,
                hasMove,
                newFrontBumpers,
                newRearBumpers,
                sonars,
                newEquipment);
    }
}
