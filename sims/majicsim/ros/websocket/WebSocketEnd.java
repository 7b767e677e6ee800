package majicsim.ros.websocket;

import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import majicsim.net.Line;
import org.jspecify.annotations.Nullable;

/**
 * One connection, from its first byte. Answers pings and a close frame by itself, sends no pings, offers no extension
 * and no subprotocol. Every method with the lab's lock held.
 */
public final class WebSocketEnd {
    private final Line line;
    private final MessageListener listener;
    private final ByteBacklog backlog = new ByteBacklog();
    private final Handshake handshake;
    private final FrameReader reader;
    private final MessageAssembler assembler;
    private State state = State.CONNECTING;
    private boolean isAnsweringPings = true;

    /**
     * Waits for the client's request.
     *
     * @param line where the client is
     * @param paths at which the server answers
     * @param mostBytes a larger message closes the connection with {@link CloseCode#TOO_BIG}
     * @param listener receives messages
     */
    public WebSocketEnd(Line line, Paths paths, long mostBytes, MessageListener listener) {
        this.line = line;
        this.listener = listener;
        this.handshake = new Handshake(paths);
        this.reader = new FrameReader(backlog, mostBytes);
        this.assembler = new MessageAssembler(mostBytes);
    }

    /**
     * Whether messages can be sent.
     *
     * @return false before the handshake and after either side has closed
     */
    public boolean isOpen() {
        return state == State.OPEN && line.isOpen();
    }

    /**
     * Sets whether pings are answered. Not answering is a fault.
     *
     * @param answers false to leave pings without pong
     */
    public void answerPings(boolean answers) {
        isAnsweringPings = answers;
    }

    /**
     * Takes what arrived.
     *
     * @param bytes in pieces of any size
     */
    public void receive(byte[] bytes) {
        backlog.put(bytes);
        if (state == State.CONNECTING) {
            shakeHands();
        }
        try {
            while (state == State.OPEN && readFrame()) {
                // Reads on until the rest is incomplete.
            }
        } catch (ProtocolViolation e) {
            close(e.closeCode(), String.valueOf(e.getMessage()));
        }
    }

    /**
     * Sends a message; without effect while the connection is not open.
     *
     * @param utf8 its text
     */
    public void sendText(byte[] utf8) {
        send(Opcode.TEXT, utf8);
    }

    /**
     * Sends a message; without effect while the connection is not open.
     *
     * @param payload its content
     */
    public void sendBinary(byte[] payload) {
        send(Opcode.BINARY, payload);
    }

    /**
     * Announces a text message whose bytes {@link #sendRaw} then brings in pieces.
     *
     * @param length of its payload, bytes
     */
    public void beginText(long length) {
        sendRaw(FrameWriter.head(Opcode.TEXT, length));
    }

    /**
     * Sends bytes that need not be frames; without effect while the connection is not open.
     *
     * @param bytes as they go out
     */
    public void sendRaw(byte[] bytes) {
        if (isOpen()) {
            line.send(bytes);
        }
    }

    /**
     * How much was sent and not read by the client.
     *
     * @return bytes kept at this end
     */
    public int unsent() {
        return line.unsent();
    }

    /**
     * Closes the connection: sends a close frame and ends the line after it.
     *
     * @param code as {@link CloseCode} lists them
     * @param reason for the client's log, short
     */
    public void close(int code, String reason) {
        if (isOpen()) {
            byte[] text = reason.getBytes(StandardCharsets.UTF_8);
            byte[] payload = ByteBuffer.allocate(2 + text.length)
                    .putShort((short) code)
                    .put(text)
                    .array();
            send(Opcode.CLOSE, payload);
        }
        end();
    }

    private void shakeHands() {
        Handshake.Answer answer = handshake.read(backlog);
        if (answer != null) {
            line.send(answer.bytes());
            if (answer.isAccepted()) {
                state = State.OPEN;
                listener.opened();
            } else {
                end();
            }
        }
    }

    private boolean readFrame() throws ProtocolViolation {
        Frame frame = reader.next();
        if (frame == null) {
            return false;
        }
        switch (frame.opcode()) {
            case PING -> answerPing(frame);
            case PONG -> {
                // A pong that was not asked for is allowed and means nothing.
            }
            case CLOSE -> answerClose(frame);
            case TEXT, BINARY, CONTINUATION -> passOn(assembler.add(frame));
        }
        return true;
    }

    private void passOn(@Nullable Frame message) throws ProtocolViolation {
        if (message != null) {
            boolean isText = message.opcode() == Opcode.TEXT;
            if (isText) {
                checkUtf8(message.payload());
            }
            listener.received(message.payload(), isText);
        }
    }

    private static void checkUtf8(byte[] payload) throws ProtocolViolation {
        try {
            StandardCharsets.UTF_8.newDecoder().decode(ByteBuffer.wrap(payload));
        } catch (CharacterCodingException e) {
            throw new ProtocolViolation(CloseCode.NOT_UTF8, "a text message is not UTF-8");
        }
    }

    private void answerPing(Frame ping) {
        if (isAnsweringPings) {
            send(Opcode.PONG, ping.payload());
        }
    }

    private void answerClose(Frame close) {
        send(Opcode.CLOSE, close.payload());
        end();
    }

    private void send(Opcode opcode, byte[] payload) {
        sendRaw(FrameWriter.message(opcode, payload));
    }

    private void end() {
        state = State.CLOSED;
        line.close();
    }

    private enum State {
        CONNECTING,
        OPEN,
        CLOSED
    }
}
