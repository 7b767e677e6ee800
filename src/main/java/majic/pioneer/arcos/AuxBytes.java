package majic.pioneer.arcos;

import java.util.Arrays;
import java.util.HexFormat;
import org.jspecify.annotations.Nullable;

/** Bytes that came in at one of the controller's own serial ports, in answer to GETAUX (ARCOS sheet 11.6). Immutable. */
public final class AuxBytes implements Report {
    private static final int AUX1 = 0xB0;
    private static final int AUX2 = 0xB8;
    private static final int AUX3 = 0xC8;

    private final int port;
    private final byte[] bytes;

    private AuxBytes(int port, byte[] bytes) {
        this.port = port;
        this.bytes = bytes;
    }

    static @Nullable AuxBytes read(Packet packet) {
        return switch (packet.type()) {
            case AUX1 -> new AuxBytes(1, packet.data());
            case AUX2 -> new AuxBytes(2, packet.data());
            case AUX3 -> new AuxBytes(3, packet.data());
            default -> null;
        };
    }

    /** Which port, 1 to 3. */
    public int port() {
        return port;
    }

    /** The bytes; a copy. */
    public byte[] bytes() {
        return bytes.clone();
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof AuxBytes aux && aux.port == port && Arrays.equals(aux.bytes, bytes);
    }

    @Override
    public int hashCode() {
        return 31 * port + Arrays.hashCode(bytes);
    }

    @Override
    public String toString() {
        return "AUX" + port + " " + HexFormat.of().formatHex(bytes);
    }
}
