package majic.gui.map;

import java.util.List;
import java.util.Locale;
import java.util.OptionalInt;
import majic.bot.Pose;
import majic.bot.Uncertainty;
import majic.lab.LabAccess.Furnishing;
import majic.lab.LabAccess.Wall;
import majic.panel.map.Trail;
import org.jspecify.annotations.Nullable;

/**
 * The content of the team map at one moment, in the room's frame: x to the right, y up, mm. Immutable, except for the
 * trails, which grow.
 *
 * @param walls the lab's walls and sides of boxes; empty without a lab
 * @param furnishing the tape and the lamps of the lab
 * @param robots by number
 * @param bystanders robots that are in the lab but not in the team
 * @param map the map of the team; null without one
 * @param startsAreGuessed whether the start of at least one robot is unknown, so that it is drawn beside the others
 */
public record MapScene(
        List<Wall> walls,
        Furnishing furnishing,
        List<Robot> robots,
        List<Bystander> bystanders,
        @Nullable MapPicture map,
        boolean startsAreGuessed) {
    public static final MapScene EMPTY = new MapScene(List.of(), Furnishing.NONE, List.of(), List.of(), null, false);

    public MapScene {
        walls = List.copyOf(walls);
        robots = List.copyOf(robots);
        bystanders = List.copyOf(bystanders);
    }

    /**
     * A robot on the map.
     *
     * @param number its number
     * @param label its name and type
     * @param bodyMm radius of its body
     * @param origin where the frame of its own poses lies
     * @param reported its estimated pose
     * @param uncertainty of that pose
     * @param truth its true pose in the lab; null without a lab
     * @param trail its earlier estimated poses; grows
     * @param connected whether the pose is kept up to date
     * @param stopUnconfirmed whether its last stop was not confirmed, so that it may still move
     * @param way on which it drives to a place; {@link PlannedWay#NONE} if it does not
     * @param heightMm of a robot that flies, in whole decimetres; 0 for others
     */
    public record Robot(
            int number,
            String label,
            double bodyMm,
            Pose origin,
            Pose reported,
            Uncertainty uncertainty,
            @Nullable Pose truth,
            Trail trail,
            boolean connected,
            boolean stopUnconfirmed,
            PlannedWay way,
            double heightMm) {
        private static final double DECIMETRE_MM = 100;
        private static final double MM_PER_M = 1000;

        /** A robot that is not higher stands, by what its altimeter errs. */
        private static final double ON_GROUND_MM = 200;

        /** A robot on the floor. */
        public Robot(
                int number,
                String label,
                double bodyMm,
                Pose origin,
                Pose reported,
                Uncertainty uncertainty,
                @Nullable Pose truth,
                Trail trail,
                boolean connected,
                boolean stopUnconfirmed,
                PlannedWay way) {
            this(
                    number,
                    label,
                    bodyMm,
                    origin,
                    reported,
                    uncertainty,
                    truth,
                    trail,
                    connected,
                    stopUnconfirmed,
                    way,
                    0);
        }

        /** Returns this robot at a height, which is rounded. */
        public Robot at(double mm) {
            return new Robot(
                    number,
                    label,
                    bodyMm,
                    origin,
                    reported,
                    uncertainty,
                    truth,
                    trail,
                    connected,
                    stopUnconfirmed,
                    way,
                    DECIMETRE_MM * Math.round(mm / DECIMETRE_MM));
        }

        /** Whether it is so high that its height is shown. */
        boolean isInAir() {
            return heightMm > ON_GROUND_MM;
        }

        /** Returns its height as users read it, m. */
        String metres() {
            return String.format(Locale.ROOT, "%.1f", heightMm / MM_PER_M);
        }
    }

    /**
     * The way of a robot to a place. Immutable.
     *
     * @param corners those that are still ahead, the place last
     * @param reserved the places on which no other robot drives now, the one of the robot first
     * @param waits why it stands, as a part of a sentence; empty while it drives
     * @param waitsFor the number of the robot that it waits for; empty if it is none of the team
     */
    public record PlannedWay(List<Pose> corners, List<Pose> reserved, String waits, OptionalInt waitsFor) {
        public static final PlannedWay NONE = new PlannedWay(List.of(), List.of());

        public PlannedWay {
            corners = List.copyOf(corners);
            reserved = List.copyOf(reserved);
        }

        /** The way of a robot that drives. */
        public PlannedWay(List<Pose> corners, List<Pose> reserved) {
            this(corners, reserved, "", OptionalInt.empty());
        }
    }

    /**
     * A robot of the lab that was not added or was removed: others can still run into it.
     *
     * @param name of its type
     * @param truth its true pose
     */
    public record Bystander(String name, Pose truth) {}
}
