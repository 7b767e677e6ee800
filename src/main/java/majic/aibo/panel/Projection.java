package majic.aibo.panel;

import java.util.function.ToDoubleFunction;
import majic.aibo.body.BodyPoint;

/** Where the drawn dog is looked at from; lengths in mm. */
enum Projection {
    /**
     * From its right and a little from behind and above, so that the legs do not hide each other; it looks to the
     * right.
     */
    SIDE(spot -> spot.x() + 0.3 * spot.y(), spot -> spot.z() + 0.05 * spot.y(), BodyPoint::y),
    /** From above; it looks upwards. */
    ABOVE(spot -> -spot.y(), BodyPoint::x, spot -> -spot.z());

    private final ToDoubleFunction<BodyPoint> across;
    private final ToDoubleFunction<BodyPoint> up;
    private final ToDoubleFunction<BodyPoint> depth;

    Projection(ToDoubleFunction<BodyPoint> across, ToDoubleFunction<BodyPoint> up, ToDoubleFunction<BodyPoint> depth) {
        this.across = across;
        this.up = up;
        this.depth = depth;
    }

    /** To the right of the picture's middle. */
    double across(BodyPoint spot) {
        return across.applyAsDouble(spot);
    }

    /** Up in the picture. */
    double up(BodyPoint spot) {
        return up.applyAsDouble(spot);
    }

    /** How far behind the dog's middle. */
    double depth(BodyPoint spot) {
        return depth.applyAsDouble(spot);
    }
}
