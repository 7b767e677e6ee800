package majic.pioneer.arcos;

/**
 * The encoder counts of the wheels, which roll over at 32 bits (ARCOS sheet 11.1). Immutable.
 *
 * @param leftTicks rising when moving ahead
 * @param rightTicks rising when moving ahead
 */
public record Encoders(int leftTicks, int rightTicks) implements Report {
    static Encoders read(FieldReader fields) {
        return new Encoders(fields.sint32(), fields.sint32());
    }
}
