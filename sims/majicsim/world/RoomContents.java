package majicsim.world;

import java.util.List;

/** What is in a room beside its walls. */
record RoomContents(List<Lamp> lamps, List<Tape> tapes) {
    static final RoomContents NONE = new RoomContents(List.of(), List.of());

    RoomContents {
        lamps = List.copyOf(lamps);
        tapes = List.copyOf(tapes);
    }
}
