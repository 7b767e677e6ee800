package majicsim.ros.websocket;

/** A client broke a rule of RFC 6455; the connection is closed with the code. */
final class ProtocolViolation extends Exception {
    private static final long serialVersionUID = 1;

    private final int closeCode;

    ProtocolViolation(int closeCode, String message) {
        super(message);
        this.closeCode = closeCode;
    }

    int closeCode() {
        return closeCode;
    }
}
