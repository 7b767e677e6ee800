package majic.pioneer.arcos;

/**
 * The names of a robot, from its answer to SYNC2 (ARCOS sheet 4). Immutable.
 *
 * @param name given by its owner
 * @param robotClass {@code Pioneer} for nearly all
 * @param subclass the model
 */
public record PioneerIdentity(String name, String robotClass, String subclass) {
    /** Decodes a packet; names that did not come are empty. */
    public static PioneerIdentity decode(Packet packet) {
        FieldReader fields = packet.fields();
        return new PioneerIdentity(fields.string(), fields.string(), fields.string());
    }

    /**
     * The model and name as they follow the make in a sentence: {@code , model p3dx-sh, named "Rosa"}; names that are
     * empty are left out.
     */
    public String details() {
        String model = subclass.isEmpty() ? "" : ", model " + subclass;
        return name.isEmpty() ? model : model + ", named \"" + name + "\"";
    }
}
