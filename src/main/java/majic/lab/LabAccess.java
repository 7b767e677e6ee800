package majic.lab;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import majic.bot.BotAddress;
import majic.bot.Pose;
import majic.time.TimeSource;

/** Gives the rest of MAJIC access to a simulated lab. Thread-safe. */
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
     * The parts of the room that robots can see but cannot run into. Immutable.
     *
     * @param tapes all pieces of all stripes
     * @param lamps all lamps that are switched on
     */
    record Furnishing(List<Tape> tapes, List<Lamp> lamps) {
        /** The furnishing of an empty room. */
        public static final Furnishing NONE = new Furnishing(List.of(), List.of());

        /** Copies the lists. */
        public Furnishing {
            tapes = List.copyOf(tapes);
            lamps = List.copyOf(lamps);
        }
    }

    /**
     * Returns what the noise of the lab begins with, so that a run can be repeated.
     *
     * @return the seed
     */
    long seed();

    /**
     * Returns the robots in the lab.
     *
     * @return their names, which are those of their types, with a number appended where there are several
     *     ({@code pioneer2}); in the order they are to be numbered
     */
    List<String> robots();

    /**
     * Returns the address at which a robot of the lab listens.
     *
     * @param robot its name
     * @return its address as a user could type it, or empty if the lab has none
     */
    Optional<BotAddress> address(String robot);

    /**
     * Returns the clock of the lab, for drivers of its robots.
     *
     * @return the same object at every call
     */
    TimeSource time();

    /**
     * Returns the robots' true poses, in the room's frame.
     *
     * @return by name of the robot, in the lab's order
     */
    Map<String, Pose> truePoses();

    /**
     * Returns how often each robot ran into something; being run into does not count.
     *
     * @return since the lab was started, by name of the robot, in the lab's order
     */
    Map<String, Integer> bumps();

    /**
     * Lifts a robot and puts it down elsewhere. Its own measurements take no part in that.
     *
     * @param robot its name
     * @param pose where to, in the room's frame
     * @throws majic.bot.BotException if the lab has no such robot, or a wall or another robot is there; the robot stays
     *     where it was
     */
    void place(String robot, Pose pose);

    /**
     * Returns the walls of the room.
     *
     * @return all walls and sides of boxes
     */
    List<Wall> walls();

    /**
     * Returns the contents of the room besides its walls.
     *
     * @return tape and lamps; none unless overridden
     */
    default Furnishing furnishing() {
        return Furnishing.NONE;
    }
}
