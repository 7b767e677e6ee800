package majic.ros.websocket;

/** What a WebSocket connection receives, in order. */
sealed interface WebSocketMessage {
    /** The answer to the request to upgrade, up to the empty line. */
    record Answer(String head) implements WebSocketMessage {}

    /** A whole text message. */
    record Text(String text) implements WebSocketMessage {}

    /** A whole binary message. */
    record Binary(byte[] bytes) implements WebSocketMessage {}

    /** A ping, whose content the pong repeats. */
    record Ping(byte[] content) implements WebSocketMessage {}

    /** The answer to a ping, with the content of the ping. */
    record Pong(byte[] content) implements WebSocketMessage {}

    /** The announcement that the server closes the connection. */
    record Close(int code, String reason) implements WebSocketMessage {}

    /**
     * A message that is not kept because it is longer than the limit; its bytes are skipped, and the connection goes
     * on.
     */
    record TooLong() implements WebSocketMessage {}

    /** Bytes that break the protocol: nothing behind them can be decoded. */
    record Violation(String what) implements WebSocketMessage {}
}
