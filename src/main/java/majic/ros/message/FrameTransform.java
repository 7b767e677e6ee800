package majic.ros.message;

/**
 * Where a frame, such as that of a sensor, is in another one, such as that of the robot. Immutable.
 *
 * @param originMm the origin of the inner frame in the outer one, mm
 * @param orientation how the inner frame is turned in the outer one
 */
public record FrameTransform(Vector originMm, Orientation orientation) {
    /** Both frames are the same. */
    public static final FrameTransform NONE = new FrameTransform(Vector.ZERO, Orientation.NONE);

    /**
     * Converts a point.
     *
     * @param inMm in the inner frame, mm
     * @return in the outer frame, mm
     */
    public Vector apply(Vector inMm) {
        return originMm.plus(orientation.rotate(inMm));
    }

    /** Returns where a frame is that is given in the inner frame of this one, in the outer frame of this one. */
    FrameTransform times(FrameTransform inner) {
        return new FrameTransform(apply(inner.originMm), orientation.times(inner.orientation));
    }

    /** Returns where the outer frame is in the inner one. */
    FrameTransform inverse() {
        Orientation back = orientation.inverse();
        return new FrameTransform(back.rotate(originMm).times(-1), back);
    }
}
