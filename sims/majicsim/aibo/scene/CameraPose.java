package majicsim.aibo.scene;

import java.util.function.UnaryOperator;

/**
 * The position and orientation of the camera: three perpendicular directions of length 1. Immutable.
 *
 * @param at its position, mm
 * @param ahead its viewing direction
 * @param left its direction to the left
 * @param up its upward direction
 */
public record CameraPose(Vector at, Vector ahead, Vector left, Vector up) {

    /** A level pose along x. */
    public static CameraPose from(Vector at) {
        return new CameraPose(at, new Vector(1, 0, 0), new Vector(0, 1, 0), new Vector(0, 0, 1));
    }

    public CameraPose moved(double aheadMm, double leftMm, double upMm) {
        return at(at.plus(new Vector(aheadMm, leftMm, upMm)));
    }

    public CameraPose at(Vector place) {
        return new CameraPose(place, ahead, left, up);
    }

    public CameraPose turned(double degrees) {
        return each(vector -> vector.turned(degrees));
    }

    public CameraPose pitched(double degrees) {
        return each(vector -> vector.pitched(degrees));
    }

    public CameraPose rolled(double degrees) {
        return each(vector -> vector.rolled(degrees));
    }

    /** The direction of a point of the picture, given by the tangents of the angles from its middle. */
    public Vector ray(double tanLeft, double tanUp) {
        return ahead.plus(left.times(tanLeft)).plus(up.times(tanUp));
    }

    private CameraPose each(UnaryOperator<Vector> turn) {
        return new CameraPose(turn.apply(at), turn.apply(ahead), turn.apply(left), turn.apply(up));
    }
}
