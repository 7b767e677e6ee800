package majicsim;

import majicsim.hemisson.options.HemissonOptions;
import majicsim.mavlink.MavlinkOptions;
import majicsim.pioneer.PioneerRobot;
import majicsim.ros.options.RosOptions;
import majicsim.world.Room;
import org.jspecify.annotations.Nullable;

/**
 * What kind of lab to open.
 *
 * @param room the room in which the robots drive
 * @param exact whether all noise is off, including jitter and the transmission times of serial lines
 * @param seed of the noise
 * @param ports the ports at which the robots listen
 * @param jitter whether exchanges take 5 to 50 ms, and the Hemisson's line has its true speed; without effect in an
 *     exact lab
 * @param pioneerModel the model of the Pioneers, a name as {@link PioneerRobot#modelNamed} returns it
 * @param hemisson the kind of Hemisson
 * @param pioneers how many Pioneers of that model, 1 to {@value #MOST_PIONEERS}; the further ones start behind the
 *     other robots; {@link #roomFor} returns a room for them
 * @param ros the kind of ROS robot; null for a lab without one
 * @param mavlink the MAVLink vehicles; null for a lab without any
 */
public record LabOptions(
        Room room,
        boolean exact,
        long seed,
        LabPorts ports,
        boolean jitter,
        String pioneerModel,
        HemissonOptions hemisson,
        int pioneers,
        @Nullable RosOptions ros,
        @Nullable MavlinkOptions mavlink) {
    /** How many Pioneers a lab has at most. */
    public static final int MOST_PIONEERS = 500;

    /** The Aibo and the Hemisson. */
    private static final int OTHER_ROBOTS = 2;

    /**
     * Checks the model and the number.
     *
     * @throws IllegalArgumentException if there is no such Pioneer, or not that many; the message lists the models
     */
    public LabOptions {
        if (pioneers < 1 || pioneers > MOST_PIONEERS) {
            throw new IllegalArgumentException("a lab has 1 to " + MOST_PIONEERS + " Pioneers, not " + pioneers);
        }
        pioneerModel = PioneerRobot.modelNamed(pioneerModel);
    }

    /**
     * A room with the space for a lab's robots.
     *
     * @param pioneers how many Pioneers; a ROS robot or MAVLink vehicle needs as much space as one
     * @return the standard room, or a larger hall
     */
    public static Room roomFor(int pioneers) {
        return Room.forRobots(pioneers + OTHER_ROBOTS);
    }

    /**
     * How many robots the lab has.
     *
     * @return all Pioneers, the Aibo, the Hemisson, the ROS robots and the MAVLink vehicles if there are any
     */
    public int robots() {
        int vehicles = mavlink == null ? 0 : mavlink.vehicles().size();
        return pioneers + OTHER_ROBOTS + (ros == null ? 0 : ros.robots()) + vehicles;
    }

    /**
     * The standard room with noise and jitter, on the usual ports.
     *
     * @return the options
     */
    public static LabOptions standard() {
        return standard(false, LabPorts.USUAL);
    }

    /**
     * The standard room without noise, on free ports, so that many labs can run side by side.
     *
     * @return the options
     */
    public static LabOptions exactOnFreePorts() {
        return standard(true, LabPorts.FREE);
    }

    /**
     * The same lab with other noise.
     *
     * @param newSeed any number
     * @return noisy options
     */
    public LabOptions withNoise(long newSeed) {
        return new LabOptions(room, false, newSeed, ports, jitter, pioneerModel, hemisson, pioneers, ros, mavlink);
    }

    /**
     * The same lab in another room.
     *
     * @param newRoom the room
     * @return the options
     */
    public LabOptions withRoom(Room newRoom) {
        return new LabOptions(newRoom, exact, seed, ports, jitter, pioneerModel, hemisson, pioneers, ros, mavlink);
    }

    /**
     * The same lab with its robots listening elsewhere.
     *
     * @param newPorts the ports
     * @return the options
     */
    public LabOptions withPorts(LabPorts newPorts) {
        return new LabOptions(room, exact, seed, newPorts, jitter, pioneerModel, hemisson, pioneers, ros, mavlink);
    }

    /**
     * The same lab with another Pioneer.
     *
     * @param newModel a name as {@link PioneerRobot#modelNamed} takes it
     * @return the options
     * @throws IllegalArgumentException if there is no such Pioneer; the message lists the models
     */
    public LabOptions withPioneer(String newModel) {
        return new LabOptions(room, exact, seed, ports, jitter, newModel, hemisson, pioneers, ros, mavlink);
    }

    /**
     * The same lab with another Hemisson.
     *
     * @param newHemisson its firmware, switches and modules, and which weaknesses of the real robot it has
     * @return the options
     */
    public LabOptions withHemisson(HemissonOptions newHemisson) {
        return new LabOptions(room, exact, seed, ports, jitter, pioneerModel, newHemisson, pioneers, ros, mavlink);
    }

    /**
     * The same lab with further Pioneers: "pioneer2", "pioneer3" and so on, on free ports.
     *
     * @param count how many in all, 1 to {@value #MOST_PIONEERS}
     * @return the options
     * @throws IllegalArgumentException if there cannot be that many
     */
    public LabOptions withPioneers(int count) {
        return new LabOptions(room, exact, seed, ports, jitter, pioneerModel, hemisson, count, ros, mavlink);
    }

    /**
     * The same lab with a ROS robot.
     *
     * @param newRos its version of ROS and what else distinguishes it; null for none
     * @return the options
     */
    public LabOptions withRos(@Nullable RosOptions newRos) {
        return new LabOptions(room, exact, seed, ports, jitter, pioneerModel, hemisson, pioneers, newRos, mavlink);
    }

    /**
     * The same lab with MAVLink vehicles.
     *
     * @param newMavlink their kinds; null for none
     * @return the options
     */
    public LabOptions withMavlink(@Nullable MavlinkOptions newMavlink) {
        return new LabOptions(room, exact, seed, ports, jitter, pioneerModel, hemisson, pioneers, ros, newMavlink);
    }

    private static LabOptions standard(boolean exact, LabPorts ports) {
        return new LabOptions(
                Room.standard(),
                exact,
                1,
                ports,
                !exact,
                PioneerRobot.STANDARD_MODEL,
                HemissonOptions.standard(),
                1,
                null,
                null);
    }
}
