package majicsim.pioneer;

import java.util.List;

/**
 * What distinguishes one kind of Pioneer from the others. Immutable.
 *
 * @param subclass what it calls itself in the handshake, such as {@code p3dx-sh}
 * @param className the class in the handshake, {@code Pioneer} for nearly all
 * @param frontMm from the turning centre to the front
 * @param rearMm from the turning centre to the rear
 * @param halfWidthMm from the turning centre to either side
 * @param topSpeedMmPerSec the fastest it drives
 * @param topTurnDegPerSec the fastest it turns
 * @param scaling the factors of its raw numbers
 * @param hasMove whether the controller knows MOVE
 * @param frontBumpers bumper segments in front, 0 to 7
 * @param rearBumpers bumper segments behind, 0 to 7
 * @param sonars the discs that are fitted, by number
 * @param equipment what else it carries
 */
record PioneerModel(
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

    /** Copies the list of discs. */
    PioneerModel {
        sonars = List.copyOf(sonars);
    }

    /**
     * The model that goes by this subclass, without regard to case.
     *
     * @throws IllegalArgumentException if there is none; the message lists those there are
     */
    static PioneerModel of(String subclass) {
        return ModelTable.find(subclass);
    }

    /** The subclasses of all models, in the order of the table. */
    static List<String> subclasses() {
        return ModelTable.subclasses();
    }

    boolean hasSonarArray(int array) {
        return sonars.stream().anyMatch(disc -> disc.array() == array);
    }
}
