package majicsim.ros.websocket;

import java.io.ByteArrayOutputStream;
import org.jspecify.annotations.Nullable;

/** Puts the frames of a message together, between which control frames may lie (RFC 6455, section 5.4). */
final class MessageAssembler {
    private final long mostBytes;
    private final ByteArrayOutputStream parts = new ByteArrayOutputStream();
    private @Nullable Opcode begun;

    MessageAssembler(long mostBytes) {
        this.mostBytes = mostBytes;
    }

    /**
     * Takes the next text, binary or continuation frame; returns the whole message as one frame, or null if parts are
     * missing.
     */
    @Nullable
    Frame add(Frame frame) throws ProtocolViolation {
        boolean continues = frame.opcode() == Opcode.CONTINUATION;
        if (continues != (begun != null)) {
            throw new ProtocolViolation(CloseCode.PROTOCOL_ERROR, "a fragment is out of order");
        }
        if (frame.isFinal() && !continues) {
            return frame;
        }
        Opcode opcode = begun == null ? frame.opcode() : begun;
        begun = opcode;
        parts.writeBytes(frame.payload());
        if (parts.size() > mostBytes) {
            throw new ProtocolViolation(CloseCode.TOO_BIG, "a message is too big");
        }
        if (!frame.isFinal()) {
            return null;
        }
        byte[] whole = parts.toByteArray();
        parts.reset();
        begun = null;
        return new Frame(true, opcode, whole);
    }
}
