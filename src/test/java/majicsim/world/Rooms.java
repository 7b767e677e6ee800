package majicsim.world;

import java.util.List;

/** Small rooms for tests. */
final class Rooms {
    private Rooms() {}

    /** A square room around the origin. */
    static Room square(double halfMm) {
        double h = halfMm;
        return of(
                new Segment(-h, -h, h, -h, 1),
                new Segment(h, -h, h, h, 1),
                new Segment(h, h, -h, h, 1),
                new Segment(-h, h, -h, -h, 1));
    }

    static Room of(Segment... walls) {
        return new Room(List.of(walls), List.of(), List.of(), RoomContents.NONE);
    }
}
