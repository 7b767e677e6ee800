package majicsim;

import majicsim.world.Room;

/**
 * What kind of lab to open.
 *
 * @param room where the robots drive
 * @param exact whether all noise is off, jitter too
 * @param seed of the noise
 * @param aiboPort TCP port, 0 for any free one; a taken default port is replaced by a free one
 * @param pioneerPort likewise
 * @param hemissonPort likewise
 * @param jitter whether exchanges take 5 to 50 ms; without effect in an exact lab
 */
public record LabOptions(
        Room room, boolean exact, long seed, int aiboPort, int pioneerPort, int hemissonPort, boolean jitter) {
    /** Where an Aibo's URBI listens. */
    public static final int AIBO_PORT = 54000;

    /** Where a Pioneer listens. */
    public static final int PIONEER_PORT = 8101;

    /**
     * Checks the ports.
     *
     * @throws IllegalArgumentException if one is not a port number
     */
    public LabOptions {
        for (int port : new int[] {aiboPort, pioneerPort, hemissonPort}) {
            if (port < 0 || port > 65535) {
                throw new IllegalArgumentException("a port must be 0 to 65535, not " + port);
            }
        }
    }

    /**
     * The standard room with noise and jitter, on the default ports.
     *
     * @return the options
     */
    public static LabOptions standard() {
        return new LabOptions(Room.standard(), false, 1, AIBO_PORT, PIONEER_PORT, 0, true);
    }

    /**
     * The standard room without noise, on free ports, so that many labs run side by side.
     *
     * @return the options
     */
    public static LabOptions exactOnFreePorts() {
        return new LabOptions(Room.standard(), true, 1, 0, 0, 0, false);
    }

    /**
     * The same lab with other noise.
     *
     * @param newSeed any number
     * @return noisy options
     */
    public LabOptions withNoise(long newSeed) {
        return new LabOptions(room, false, newSeed, aiboPort, pioneerPort, hemissonPort, jitter);
    }

    /**
     * The same lab in another room.
     *
     * @param newRoom the room
     * @return the options
     */
    public LabOptions withRoom(Room newRoom) {
        return new LabOptions(newRoom, exact, seed, aiboPort, pioneerPort, hemissonPort, jitter);
    }
}
