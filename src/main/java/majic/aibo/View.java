package majic.aibo;

import java.util.function.ToDoubleFunction;

/** Where the drawn dog is looked at from; lengths in mm. */
enum View {
    /** From its right; it looks to the right, up is up. */
    SIDE(Spot::x, Spot::z, Spot::y),
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
