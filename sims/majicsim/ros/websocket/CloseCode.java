package majicsim.ros.websocket;

/** Reasons to close a connection (RFC 6455, section 7.4.1). */
public final class CloseCode {
    /** The purpose of the connection is fulfilled. */
    public static final int NORMAL = 1000;

    /** The client broke the rules of the protocol. */
    public static final int PROTOCOL_ERROR = 1002;

    /** A close frame without a code; never sent. */
    public static final int NONE = 1005;

    /** A text message is not UTF-8. */
    public static final int NOT_UTF8 = 1007;

    /** A message is larger than the server takes. */
    public static final int TOO_BIG = 1009;

    private CloseCode() {}
}
