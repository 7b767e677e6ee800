package majic.aibo.panel;

import java.util.function.ToDoubleFunction;
import majic.aibo.body.Spot;

/** Where the drawn dog is looked at from; lengths in mm. */
enum View {
    /** From its right and a little from behind and above, so that the legs do not hide each other; it looks to the right. */
    SIDE(spot -> spot.x() + 0.3 * spot.y(), spot -> spot.z() + 0.05 * spot.y(), Spot::y),
    /** From above; it looks upwards. */
    ABOVE(spot -> -spot.y(), Spot::x, spot -> -spot.z());

    private final ToDoubleFunction<Spot> across;
    private final ToDoubleFunction<Spot> up;
    private final ToDoubleFunction<Spot> depth;

    View(ToDoubleFunction<Spot> across, ToDoubleFunction<Spot> up, ToDoubleFunction<Spot> depth) {
        this.across = across;
        this.up = up;
        this.depth = depth;
    }

    /** To the right of the picture's middle. */
    double across(Spot spot) {
        return across.applyAsDouble(spot);
    }

    /** Up in the picture. */
    double up(Spot spot) {
        return up.applyAsDouble(spot);
    }

    /** How far behind the dog's middle. */
    double depth(Spot spot) {
        return depth.applyAsDouble(spot);
    }
}
