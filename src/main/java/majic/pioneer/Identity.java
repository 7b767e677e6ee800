package majic.pioneer;

/**
 * How a robot introduces itself in the answer to SYNC2 (ARCOS sheet 4). Immutable.
 *
 * @param name the owner's name for it
 * @param robotClass {@code Pioneer} for nearly all
 * @param subclass the model
 */
record Identity(String name, String robotClass, String subclass) {

    static Identity decode(Packet packet) {
        Fields fields = packet.fields();
        return new Identity(fields.string(), fields.string(), fields.string());
    }
}
