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
 * @param watchdogMs after how long without a packet it stops, ms; 0 for never
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
        Equipment equipment,
        int watchdogMs) {
    /** The factory setting (ARCOS sheet 5.3). */
    static final int USUAL_WATCHDOG_MS = 2000;

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
        String plain = ModelTable.subclassAt(name);
        PioneerModel model = ModelTable.find(plain);
        String[] extras = name.substring(plain.length()).split("\\+", -1);
        for (int i = 1; i < extras.length; i++) {
            model = Extra.named(extras[i]).fitTo(model);
        }
        return model;
    }

    /** The subclasses of all models, in the order of the table. */
    public static List<String> subclasses() {
        return ModelTable.subclasses();
    }

    PioneerModel with(Equipment newEquipment) {
        return with(subclass, frontBumpers, rearBumpers, sonars, newEquipment, watchdogMs);
    }

    /** With as many bumper segments as the vendor fits (ARCOS sheet 12), unless it has its own. */
    PioneerModel withBumpers() {
        return with(subclass, orFitted(frontBumpers), orFitted(rearBumpers), sonars, equipment, watchdogMs);
    }

    private static int orFitted(int segments) {
        return segments == 0 ? FITTED_SEGMENTS : segments;
    }

    /** Without the sonars in front, or without those behind, of which CONFIG tells. */
    PioneerModel withoutSonars(boolean front) {
        List<SonarDisc> left = sonars.stream()
                .filter(disc -> isFrontArray(disc.array()) != front)
                .toList();
        return with(subclass, frontBumpers, rearBumpers, left, equipment, watchdogMs);
    }

    /** Never stopping by itself. */
    PioneerModel withoutWatchdog() {
        return with(subclass, frontBumpers, rearBumpers, sonars, equipment, 0);
    }

    /** Announcing itself by a name that is in no table. */
    PioneerModel unlisted() {
        return with(subclass + "-unlisted", frontBumpers, rearBumpers, sonars, equipment, watchdogMs);
    }

    /** Whether a sonar array that looks ahead is fitted, or one that looks back. */
    public boolean hasSonars(boolean front) {
        return sonars.stream().anyMatch(disc -> isFrontArray(disc.array()) == front);
    }

    /** The discs of an array look ahead or back as a whole; those of an AmigoBot's only array mostly ahead. */
    private boolean isFrontArray(int array) {
        double ahead = 0;
        for (SonarDisc disc : sonars) {
            ahead += disc.array() == array ? Math.cos(Math.toRadians(disc.axisDeg())) : 0;
        }
        return ahead >= 0;
    }

    private PioneerModel with(
            String newSubclass,
            int newFrontBumpers,
            int newRearBumpers,
            List<SonarDisc> newSonars,
            Equipment newEquipment,
            int newWatchdogMs) {
        return new PioneerModel(
                newSubclass,
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
                newSonars,
                newEquipment,
                newWatchdogMs);
    }
}
