package majic.ros.websocket;

import org.jspecify.annotations.Nullable;

/** The kinds of frames (RFC 6455, 5.2). */
enum Opcode {
    CONTINUATION(0x0),
    TEXT(0x1),
    BINARY(0x2),
    CLOSE(0x8),
    PING(0x9),
    PONG(0xA);

    /** The bit that distinguishes control frames, which are short and may come between the frames of a message. */
    private static final int CONTROL = 0x8;

    private final int code;

    Opcode(int code) {
        this.code = code;
    }

    int code() {
        return code;
    }

    boolean isControl() {
        return (code & CONTROL) != 0;
    }

    /** Returns the kind; null for a reserved number. */
    static @Nullable Opcode of(int code) {
        for (Opcode opcode : values()) {
            if (opcode.code == code) {
                return opcode;
            }
        }
        return null;
    }
}
