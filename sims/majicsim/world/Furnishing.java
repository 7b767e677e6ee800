package majicsim.world;

import java.util.List;

/** What is in a room beside its walls. */
record Furnishing(List<Lamp> lamps, List<Tape> tapes) {
    static final Furnishing NONE = new Furnishing(List.of(), List.of());

    Furnishing {
        lamps = List.copyOf(lamps);
        tapes = List.copyOf(tapes);
    }
}
