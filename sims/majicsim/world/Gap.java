package majicsim.world;

/**
 * The room left between two shapes.
 *
 * @param mm the shortest distance; 0 or below when they touch or overlap
 * @param nearest the point of the second shape nearest to the first; where they overlap, a point of the overlap's edge
 */
record Gap(double mm, Point nearest) {

    static Gap between(Shape a, Shape b) {
        return new GapFinder(a, b).find();
    }

    static Gap nearer(Gap one, Gap other) {
        return other.mm < one.mm ? other : one;
    }
}
