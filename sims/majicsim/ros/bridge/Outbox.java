package majicsim.ros.bridge;

import java.util.ArrayDeque;
import java.util.Arrays;
import majicsim.ros.websocket.CloseCode;
import majicsim.ros.websocket.WebSocketEnd;

/**
 * What waits to be sent to one client. The line drops what a client leaves unread for too long, so only as much as it
 * surely keeps is handed to it.
 */
final class Outbox {
    /** A client with more unread than this is slow: ROS 1 stops writing to it. */
    private static final int FULL_BYTES = 64 * 1024;

    private static final int PIECE_BYTES = 256 * 1024;

    /** ROS 2 keeps everything for a slow client; so much is enough to show it. */
    private static final long MOST_BYTES = 256L << 20;

    private final WebSocketEnd socket;
    private final ArrayDeque<Waiting> waiting = new ArrayDeque<>();
    private long waitingBytes;

    Outbox(WebSocketEnd socket) {
        this.socket = socket;
    }

    void text(byte[] utf8) {
        if (utf8.length > PIECE_BYTES || !waiting.isEmpty() || isFull()) {
            keep(new Waiting(utf8, true));
        } else {
            socket.sendText(utf8);
        }
    }

    void binary(byte[] payload) {
        if (!waiting.isEmpty() || isFull()) {
            keep(new Waiting(payload, false));
        } else {
            socket.sendBinary(payload);
        }
    }

    /** Whether the client leaves unread what it was sent. */
    boolean isFull() {
        return socket.unsent() > FULL_BYTES;
    }

    boolean isEmpty() {
        return waiting.isEmpty();
    }

    /** Sends what the line keeps. */
    void step() {
        while (!waiting.isEmpty() && !isFull()) {
            Waiting first = waiting.element();
            int sent = first.sendPiece(socket);
            waitingBytes -= sent;
            if (first.isSent()) {
                waiting.remove();
            }
            if (sent == PIECE_BYTES) {
                return;
            }
        }
    }

    private void keep(Waiting message) {
        waiting.add(message);
        waitingBytes += message.bytes.length;
        if (waitingBytes > MOST_BYTES) {
            waiting.clear();
            waitingBytes = 0;
            socket.close(CloseCode.NORMAL, "the client does not read");
        } else {
            step();
        }
    }

    /** One message, and how much of it has been handed to the line. */
    private static final class Waiting {
        private final byte[] bytes;
        private final boolean isText;
        private int sent;

        Waiting(byte[] bytes, boolean isText) {
            this.bytes = bytes;
            this.isText = isText;
        }

        int sendPiece(WebSocketEnd socket) {
            if (sent == 0 && !isText) {
                socket.sendBinary(bytes);
                sent = bytes.length;
                return sent;
            }
            if (sent == 0) {
                socket.beginText(bytes.length);
            }
            int from = sent;
            sent = Math.min(bytes.length, from + PIECE_BYTES);
            socket.sendRaw(Arrays.copyOfRange(bytes, from, sent));
            return sent - from;
        }

        boolean isSent() {
            return sent == bytes.length;
        }
    }
}
