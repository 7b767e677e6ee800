package majic.mavlink.session;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.TreeMap;
import majic.mavlink.message.VehicleHeartbeat;

/** The modes of one kind of vehicle under one autopilot: their numbers depend on both (MAVLink sheet 3). Immutable. */
public final class FlightModes {
    private static final int ARDUPILOT = 3;
    private static final int PX4 = 12;
    private static final String GUIDED = "GUIDED";
    private static final String HOLD = "HOLD";
    private static final String STOP_OF_BOAT = "LOITER";

    private static final Map<String, Long> ROVER = ofArduPilot(
            "MANUAL 0 ACRO 1 STEERING 3 HOLD 4 LOITER 5 FOLLOW 6 SIMPLE 7 DOCK 8 CIRCLE 9 AUTO 10 RTL 11 SMART_RTL 12"
                    + " GUIDED 15 INITIALISING 16");
    private static final Map<String, Long> COPTER = ofArduPilot(
            "STABILIZE 0 ACRO 1 ALT_HOLD 2 AUTO 3 GUIDED 4 LOITER 5 RTL 6 CIRCLE 7 LAND 9 DRIFT 11 AUTOTUNE 15"
                    + " POSHOLD 16 BRAKE 17 AVOID_ADSB 19 GUIDED_NOGPS 20 SMART_RTL 21");
    private static final Map<String, Long> SUBMARINE = ofArduPilot(
            "STABILIZE 0 ACRO 1 ALT_HOLD 2 AUTO 3 GUIDED 4 CIRCLE 7 SURFACE 9 POSHOLD 16 MANUAL 19 MOTOR_DETECT 20"
                    + " SURFTRAK 21");

    /** Not on the sheet: the ArduPlane numbers that a stop and a return need. */
    private static final Map<String, Long> PLANE = ofArduPilot("MANUAL 0 CIRCLE 1 AUTO 10 RTL 11 LOITER 12 GUIDED 15");

    /** The main mode is in bits 16 to 23, its part above. */
    private static final Map<String, Long> OF_PX4 = Map.of(
            "MANUAL", px4(1, 0),
            "ALTITUDE", px4(2, 0),
            "POSITION", px4(3, 0),
            "TAKEOFF", px4(4, 2),
            "HOLD", px4(4, 3),
            "MISSION", px4(4, 4),
            "RETURN", px4(4, 5),
            "LAND", px4(4, 6),
            "OFFBOARD", px4(6, 0),
            "STABILIZED", px4(7, 0));

    private final int autopilot;
    private final Map<String, Long> numbers;
    private final String stop;
    private final String home;
    private final String down;

    private FlightModes(int autopilot, Map<String, Long> numbers, String stop, String home, String down) {
        this.autopilot = autopilot;
        this.numbers = numbers;
        this.stop = stop;
        this.home = home;
        this.down = down;
    }

    /** Returns the modes of the vehicle that has sent a heartbeat. */
    public static FlightModes of(VehicleHeartbeat heartbeat) {
        if (heartbeat.autopilot() == PX4) {
            return new FlightModes(PX4, OF_PX4, HOLD, "RETURN", "LAND");
        }
        if (heartbeat.autopilot() != ARDUPILOT) {
            return new FlightModes(heartbeat.autopilot(), Map.of(), "", "", "");
        }
        return switch (VehicleClass.of(heartbeat)) {
            case ROVER -> new FlightModes(ARDUPILOT, ROVER, HOLD, "RTL", "");
            case BOAT -> new FlightModes(ARDUPILOT, ROVER, STOP_OF_BOAT, "RTL", "");
            case COPTER -> new FlightModes(ARDUPILOT, COPTER, "BRAKE", "RTL", "LAND");
            case SUBMARINE -> new FlightModes(ARDUPILOT, SUBMARINE, "POSHOLD", "", "SURFACE");
            case PLANE -> new FlightModes(ARDUPILOT, PLANE, "LOITER", "RTL", "");
            case OTHER -> new FlightModes(ARDUPILOT, Map.of(), "", "", "");
        };
    }

    private static Map<String, Long> ofArduPilot(String text) {
        Map<String, Long> modes = new TreeMap<>();
        String[] words = text.split(" ");
        for (int index = 0; index < words.length; index += 2) {
            modes.put(words[index], Long.valueOf(words[index + 1]));
        }
        return modes;
    }

    private static long px4(int main, int sub) {
        return (long) main << 16 | (long) sub << 24;
    }

    /** Whether the autopilot is PX4. */
    public boolean isPx4() {
        return autopilot == PX4;
    }

    /** Whether the autopilot is ArduPilot. */
    public boolean isArduPilot() {
        return autopilot == ARDUPILOT;
    }

    /** Whether MAJIC knows the numbers of the modes. */
    public boolean isKnown() {
        return !numbers.isEmpty();
    }

    /** Returns the names of all modes, in order. */
    public List<String> names() {
        return numbers.keySet().stream().sorted().toList();
    }

    /** Returns the name of a mode; its number if it has none here. */
    public String name(long number) {
        return numbers.entrySet().stream()
                .filter(mode -> mode.getValue() == number)
                .map(Map.Entry::getKey)
                .findFirst()
                .orElse("mode " + number);
    }

    /** Returns the number of a mode; empty for a name that there is not. */
    public OptionalLong number(String name) {
        Long number = numbers.get(name.toUpperCase(Locale.ROOT));
        return number == null ? OptionalLong.empty() : OptionalLong.of(number);
    }

    /** Returns the mode in which targets are followed; empty if MAJIC does not drive this vehicle. */
    public OptionalLong guided() {
        return isPx4() ? OptionalLong.empty() : number(GUIDED);
    }

    /** Returns the mode of a stop; empty if none is known. */
    public OptionalLong stop() {
        return number(stop);
    }

    /**
     * Returns the mode of a stop where the usual one is refused: HOLD of a boat that does not know its place, and so
     * cannot keep it.
     */
    public OptionalLong otherStop() {
        return isArduPilot() && stop.equals(STOP_OF_BOAT) && numbers.containsKey(HOLD)
                ? number(HOLD)
                : OptionalLong.empty();
    }

    /** Returns the mode that leads home; empty if there is none. */
    public Optional<String> home() {
        return home.isEmpty() ? Optional.empty() : Optional.of(home);
    }

    /** Returns the mode that leads to the ground, or to the surface of the water; empty if there is none. */
    public Optional<String> down() {
        return down.isEmpty() ? Optional.empty() : Optional.of(down);
    }

    /** Returns the parameters of the command that sets a mode. */
    public double[] arguments(long number) {
        return isPx4() ? new double[] {1, number >> 16 & 0xFF, number >> 24} : new double[] {1, number};
    }
}
