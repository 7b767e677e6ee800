package majicsim.aibo;

import java.util.function.UnaryOperator;

/**
 * Where an eye is and how it is turned: three directions of length 1 at right angles. Immutable.
 *
 * @param at where it is, mm
 * @param ahead where it looks
 * @param left what is left for it
 * @param up what is up for it
 */
record View(Vector at, Vector ahead, Vector left, Vector up) {

    /** Looks level along x. */
    static View from(Vector at) {
        return new View(at, new Vector(1, 0, 0), new Vector(0, 1, 0), new Vector(0, 0, 1));
    }

    View moved(double aheadMm, double leftMm, double upMm) {
        return at(at.plus(new Vector(aheadMm, leftMm, upMm)));
    }

    View at(Vector place) {
        return new View(place, ahead, left, up);
    }

    View turned(double degrees) {
        return each(vector -> vector.turned(degrees));
    }

    View pitched(double degrees) {
        return each(vector -> vector.pitched(degrees));
    }

    View rolled(double degrees) {
        return each(vector -> vector.rolled(degrees));
    }

    /** The direction of what it sees that far from its middle, as tangents of the angles. */
    Vector ray(double tanLeft, double tanUp) {
        return ahead.plus(left.times(tanLeft)).plus(up.times(tanUp));
    }

    private View each(UnaryOperator<Vector> turn) {
        return new View(turn.apply(at), turn.apply(ahead), turn.apply(left), turn.apply(up));
    }
}
