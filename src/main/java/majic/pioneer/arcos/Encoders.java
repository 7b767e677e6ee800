package majic.pioneer.arcos;

import org.jspecify.annotations.Nullable;

/**
 * The encoder counts of the wheels, which roll over at 32 bits (ARCOS sheet 11.1). Immutable.
 *
 * @param leftTicks rising when moving ahead
 * @param rightTicks rising when moving ahead
 */
public record Encoders(int leftTicks, int rightTicks) implements Report {
    static final int TYPE = 0x90;
    private static final int BYTES = 8;

    static @Nullable Encoders read(FieldReader fields) {
        return fields.remaining() < BYTES ? null : new Encoders(fields.sint32(), fields.sint32());
    }
}
