package majicsim.ros.websocket;

/**
 * One frame, unmasked.
 *
 * @param isFinal whether it ends its message
 * @param opcode its kind
 * @param payload its content, not changed afterwards
 */
record Frame(boolean isFinal, Opcode opcode, byte[] payload) {}
