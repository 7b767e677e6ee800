package majic.pioneer.arcos;

/**
 * How a robot introduces itself in the answer to SYNC2 (ARCOS sheet 4). Immutable.
 *
 * @param name the owner's name for it
 * @param robotClass {@code Pioneer} for nearly all
 * @param subclass the model
 */
public record PioneerIdentity(String name, String robotClass, String subclass) {
    /** Decodes a packet; names that did not come are empty. */
    public static PioneerIdentity decode(Packet packet) {
        FieldReader fields = packet.fields();
        return new PioneerIdentity(fields.string(), fields.string(), fields.string());
    }

    /** What follows the make in a sentence: {@code , model p3dx-sh, named "Rosa"}; names that are empty are left out. */
    public String details() {
        String model = subclass.isEmpty() ? "" : ", model " + subclass;
        return name.isEmpty() ? model : model + ", named \"" + name + "\"";
    }
}
