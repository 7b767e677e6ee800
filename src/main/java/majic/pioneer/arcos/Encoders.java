package majic.pioneer.arcos;

import org.jspecify.annotations.Nullable;

/**
 * The wheels' counters, which roll over at 32 bits (ARCOS sheet 11.1). Immutable.
 *
 * @param leftTicks ahead counts up
 * @param rightTicks ahead counts up
 */
public record Encoders(int leftTicks, int rightTicks) implements Report {
    static final int TYPE = 0x90;
    private static final int BYTES = 8;

    static @Nullable Encoders read(FieldReader fields) {
        return fields.remaining() < BYTES ? null : new Encoders(fields.sint32(), fields.sint32());
    }
}
