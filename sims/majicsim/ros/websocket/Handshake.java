package majicsim.ros.websocket;

import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.Base64;
import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/** The HTTP request that opens a connection, and the server's answer (RFC 6455, section 4.2). */
final class Handshake {
    private static final int MOST_BYTES = 16_384;

    /** Appended to the client's key (RFC 6455, section 1.3). */
    private static final String ACCEPT_SUFFIX = "258EAFA5-E914-47DA-95CA-C5AB0DC85B11";

    private static final String END = "\r\n\r\n";

    private final Paths paths;
    private final StringBuilder head = new StringBuilder();

    Handshake(Paths paths) {
        this.paths = paths;
    }

    /** Takes bytes up to the end of the request; returns the answer, or null while the request is incomplete. */
    @Nullable
    Answer read(ByteBacklog backlog) {
        while (backlog.available() > 0) {
            head.append((char) (backlog.take(1)[0] & 0xFF));
            if (head.indexOf(END, Math.max(0, head.length() - END.length())) >= 0) {
                return answer(head.toString());
            }
            if (head.length() > MOST_BYTES) {
                return refusal("431 Request Header Fields Too Large");
            }
        }
        return null;
    }

    private Answer answer(String request) {
        String[] lines = request.split("\r\n");
        String[] words = lines[0].split(" ");
        if (words.length != 3 || !words[0].equals("GET") || !words[2].equals("HTTP/1.1")) {
            return refusal("400 Bad Request");
        }
        Map<String, String> fields = fields(lines);
        if (!fields.getOrDefault("upgrade", "").equalsIgnoreCase("websocket")) {
            return refusal("426 Upgrade Required");
        }
        String key = fields.get("sec-websocket-key");
        if (key == null || !"13".equals(fields.get("sec-websocket-version"))) {
            return refusal("400 Bad Request");
        }
        if (paths == Paths.ROOT && !words[1].split("\\?", 2)[0].equals("/")) {
            return refusal("404 Not Found");
        }
        return new Answer(
                true,
                "HTTP/1.1 101 Switching Protocols\r\nUpgrade: WebSocket\r\nConnection: Upgrade\r\nSec-WebSocket-Accept: "
                        + accept(key)
                        + END);
    }

    private static Map<String, String> fields(String[] lines) {
        Map<String, String> fields = new HashMap<>();
        for (int i = 1; i < lines.length; i++) {
            int colon = lines[i].indexOf(':');
            if (colon > 0) {
                String name = lines[i].substring(0, colon).toLowerCase(Locale.ROOT);
                fields.put(name, lines[i].substring(colon + 1).trim());
            }
        }
        return fields;
    }

    private static Answer refusal(String status) {
        String body = "This is a rosbridge server: " + status + ".\n";
        return new Answer(
                false,
                "HTTP/1.1 " + status + "\r\nUpgrade: WebSocket\r\nContent-Type: text/plain\r\nConnection: close"
                        + "\r\nContent-Length: " + body.length() + END + body);
    }

    private static String accept(String key) {
        try {
            MessageDigest sha1 = MessageDigest.getInstance("SHA-1");
            byte[] digest = sha1.digest((key + ACCEPT_SUFFIX).getBytes(StandardCharsets.ISO_8859_1));
            return Base64.getEncoder().encodeToString(digest);
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException("every Java has SHA-1", e);
        }
    }

    /** What the server sends back, and whether the connection is open from then on. */
    record Answer(boolean isAccepted, String text) {
        byte[] bytes() {
            return text.getBytes(StandardCharsets.ISO_8859_1);
        }
    }
}
