package majic.mavlink.message;

import majic.mavlink.frame.Payload;

/**
 * A GPS_RAW_INT. Immutable.
 *
 * @param fix as GPS_FIX_TYPE numbers it
 * @param satellites in use; 255 if unknown
 */
public record GpsFix(int fix, int satellites) {
    private static final int UNKNOWN = 255;

    /** Reads the fields (MAVLink sheet 6). */
    public static GpsFix of(Payload payload) {
        return new GpsFix(payload.u8(28), payload.u8(29));
    }

    /** Whether the number of satellites is known. */
    public boolean countsSatellites() {
        return satellites != UNKNOWN;
    }

    /** Returns the kind of fix, for users. */
    public String title() {
        return switch (fix) {
            case 0 -> "no GPS";
            case 1 -> "no fix";
            case 2 -> "2-D";
            case 3 -> "3-D";
            case 4 -> "DGPS";
            case 5 -> "RTK float";
            case 6 -> "RTK fixed";
            case 7 -> "static";
            case 8 -> "PPP";
            default -> "fix " + fix;
        };
    }
}
