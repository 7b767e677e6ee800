package majicsim.mavlink;

import java.util.Arrays;
import java.util.List;

/**
 * The MAVLink vehicles of a lab. Immutable.
 *
 * @param vehicles their kinds in order, 1 to {@value #MOST_VEHICLES}; their system ids are 1, 2 and so on
 */
public record MavlinkOptions(List<VehicleOptions> vehicles) {
    /** How many a lab has at most. */
    public static final int MOST_VEHICLES = 9;

    /**
     * Copies the list.
     *
     * @throws IllegalArgumentException if there are none or too many
     */
    public MavlinkOptions {
        vehicles = List.copyOf(vehicles);
        if (vehicles.isEmpty() || vehicles.size() > MOST_VEHICLES) {
            throw new IllegalArgumentException(
                    "a lab has 1 to " + MOST_VEHICLES + " MAVLink vehicles, not " + vehicles.size());
        }
    }

    /**
     * Parses vehicles with commas between them; each is a kind, with its differences behind plus signs, in any case.
     *
     * @param models such as {@code rover,copter+ready}
     * @return the options
     * @throws IllegalArgumentException if there is no such vehicle; the message names the wrong word and the right ones
     */
    public static MavlinkOptions parse(String models) {
        return new MavlinkOptions(
                Arrays.stream(models.split(",", -1)).map(VehicleOptions::parse).toList());
    }
}
