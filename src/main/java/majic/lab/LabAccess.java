package majic.lab;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import majic.bot.BotAddress;
import majic.bot.Pose;
import majic.time.TimeSource;

/** What the rest of MAJIC may know of a simulated lab. Thread-safe. */
public interface LabAccess {
    /**
     * A wall or the side of a box, in the room's frame.
     *
     * @param x1 one end, mm
     * @param y1 one end, mm
     * @param x2 the other end, mm
     * @param y2 the other end, mm
     */
    record Wall(double x1, double y1, double x2, double y2) {}

    /**
     * A straight piece of dark tape on the floor, in the room's frame.
     *
     * @param x1 one end, mm
     * @param y1 one end, mm
     * @param x2 the other end, mm
     * @param y2 the other end, mm
     */
    record Tape(double x1, double y1, double x2, double y2) {}

    /**
     * A lamp above the floor, in the room's frame.
     *
     * @param x to the right, mm
     * @param y up, mm
     */
    record Lamp(double x, double y) {}

    /**
     * What robots see but do not run into. Immutable.
     *
     * @param tapes all pieces of all stripes
     * @param lamps all that shine
     */
    record Furnishing(List<Tape> tapes, List<Lamp> lamps) {
        /** A bare room's. */
        public static final Furnishing NONE = new Furnishing(List.of(), List.of());

        /** Copies the lists. */
        public Furnishing {
            tapes = List.copyOf(tapes);
            lamps = List.copyOf(lamps);
        }
    }

    /**
     * The robots in the lab.
     *
     * @return their names, which are those of their types, with a number behind where there are several ({@code
     *     pioneer2}); in the order they are to be numbered
     */
    List<String> robots();

    /**
     * Where a robot of the lab listens.
     *
     * @param robot its name
     * @return its address as a user could type it, or empty if the lab has none
     */
    Optional<BotAddress> address(String robot);

    /**
     * The clock of the lab, for drivers of its robots.
     *
     * @return the same object at every call
     */
    TimeSource time();

    /**
     * Where the robots really are, in the room's frame.
     *
     * @return by name of the robot, in the lab's order
     */
    Map<String, Pose> truePoses();

    /**
     * The room.
     *
     * @return all walls and sides of boxes
     */
    List<Wall> walls();

    /**
     * What is in the room beside its walls.
     *
     * @return tape and lamps; none unless overridden
     */
    default Furnishing furnishing() {
        return Furnishing.NONE;
    }
}
