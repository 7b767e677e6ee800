package majic.ros.websocket;

import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.security.SecureRandom;
import java.util.Base64;
import org.jspecify.annotations.Nullable;

/**
 * The HTTP request that turns a connection into a WebSocket, and the check of its answer (RFC 6455, 4.1). Immutable.
 */
final class Upgrade {
    private static final String GUID = "258EAFA5-E914-47DA-95CA-C5AB0DC85B11";
    private static final int KEY_BYTES = 16;

    private final String host;
    private final String path;
    private final String key;

    /**
     * Creates a request with a new key.
     *
     * @param host the server as an address names it, with its port
     * @param path begins with a slash
     */
    Upgrade(String host, String path) {
        this(host, path, newKey());
    }

    Upgrade(String host, String path, String key) {
        this.host = host;
        this.path = path;
        this.key = key;
    }

    private static String newKey() {
        byte[] random = new byte[KEY_BYTES];
        new SecureRandom().nextBytes(random);
        return Base64.getEncoder().encodeToString(random);
    }

    /** Returns the bytes of the request. */
    byte[] request() {
        String text = "GET " + path + " HTTP/1.1\r\nHost: " + host
                + "\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Key: " + key
                + "\r\nSec-WebSocket-Version: 13\r\n\r\n";
        return text.getBytes(StandardCharsets.US_ASCII);
    }

    /**
     * Checks the answer.
     *
     * @param head its lines up to the empty one
     * @return null if the connection is a WebSocket now; otherwise the status line of the answer
     */
    @Nullable
    String refusal(String head) {
        String[] lines = head.split("\r?\n", -1);
        boolean accepted = false;
        for (String line : lines) {
            int colon = line.indexOf(':');
            if (colon > 0 && line.substring(0, colon).strip().equalsIgnoreCase("Sec-WebSocket-Accept")) {
                accepted = line.substring(colon + 1).strip().equals(acceptance());
            }
        }
        return accepted && lines[0].matches("HTTP/1\\.1 101\\b.*") ? null : lines[0].strip();
    }

    private String acceptance() {
        try {
            MessageDigest sha1 = MessageDigest.getInstance("SHA-1");
            byte[] digest = sha1.digest((key + GUID).getBytes(StandardCharsets.US_ASCII));
            return Base64.getEncoder().encodeToString(digest);
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException("every Java has SHA-1", e);
        }
    }
}
