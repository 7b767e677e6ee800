package majicsim.ros.bridge;

import com.fasterxml.jackson.databind.JsonNode;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;

/** Whether a client may use a bridge that demands authentication (sheet 2, access). */
final class Authentication {
    private static final String[] SIGNED = {"client", "dest", "rand", "t", "level", "end"};

    private final String secret;
    private boolean isPassed;

    /** An empty secret demands nothing. */
    Authentication(String secret) {
        this.secret = secret;
        this.isPassed = secret.isEmpty();
    }

    boolean isPassed() {
        return isPassed;
    }

    /** Checks the first object of a client; returns whether the connection may go on. A success is not answered. */
    boolean check(JsonNode message) {
        StringBuilder signed = new StringBuilder(secret);
        for (String field : SIGNED) {
            signed.append(message.path(field).asText());
        }
        isPassed = message.path("op").asText().equals("auth")
                && sha512(signed.toString()).equals(message.path("mac").asText());
        return isPassed;
    }

    private static String sha512(String text) {
        try {
            MessageDigest digest = MessageDigest.getInstance("SHA-512");
            return HexFormat.of().formatHex(digest.digest(text.getBytes(StandardCharsets.UTF_8)));
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException("every Java has SHA-512", e);
        }
    }
}
