package majic.pioneer.arcos;

import java.util.Arrays;
import java.util.HexFormat;

/**
 * The packet of a tilting compass (ARCOS sheet 11.6), whose layout is the compass maker's and not known here; the heading
 * of every compass is in the SIP. Immutable.
 */
public final class CompassBytes implements Report {
    static final int TYPE = 0xC0;

    private final byte[] bytes;

    CompassBytes(byte[] bytes) {
        this.bytes = bytes;
    }

    /** The bytes; a copy. */
    public byte[] bytes() {
        return bytes.clone();
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof CompassBytes compass && Arrays.equals(compass.bytes, bytes);
    }

    @Override
    public int hashCode() {
        return Arrays.hashCode(bytes);
    }

    @Override
    public String toString() {
        return "compass " + HexFormat.of().formatHex(bytes);
    }
}
