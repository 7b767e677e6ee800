package majic.server;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.SecureRandom;
import java.util.Base64;
import org.jspecify.annotations.Nullable;

/**
 * The token that a client of the line server sends first, to show that it belongs to the user that started MAJIC: a new
 * random word at each start, in a file that only this user can read, or a word that the user has chosen.
 *
 * @param word the token
 * @param file where it is kept while the server listens; null for a token that the user has chosen
 */
public record ListenToken(String word, @Nullable Path file) {
    /** The environment variable with a token of the user's choice. */
    public static final String VARIABLE = "MAJIC_TOKEN";

    /** The answer to a wrong token from another computer. */
    static final String HINT = "the first line must be the token of this MAJIC";

    private static final int RANDOM_BYTES = 24;
    private static final int SHORTEST = 20;

    /**
     * Creates a token and writes its file, replacing one of an earlier start.
     *
     * @param folder the folder of the file
     * @param port the server's, which names the file
     * @return the token
     * @throws IOException if the file cannot be written, or not be kept from other users
     */
    public static ListenToken create(Path folder, int port) throws IOException {
        byte[] random = new byte[RANDOM_BYTES];
        new SecureRandom().nextBytes(random);
        String word = Base64.getUrlEncoder().withoutPadding().encodeToString(random);
        Path file = folder.resolve("listen-" + port + ".token");
        Files.deleteIfExists(file);
        OwnerOnlyFile.write(file, (word + "\n").getBytes(StandardCharsets.UTF_8));
        return new ListenToken(word, file);
    }

    /**
     * Returns the token that the user has chosen in the environment variable {@value #VARIABLE}.
     *
     * @param word its value
     * @return a token without file
     * @throws IllegalArgumentException if others could guess it or could not send it in one word; the message says so
     */
    public static ListenToken chosen(String word) {
        if (!word.matches("[!-~]{" + SHORTEST + ",200}")) {
            throw new IllegalArgumentException("the token in " + VARIABLE + " must be one word of " + SHORTEST
                    + " to 200 letters, digits and signs of ASCII; \"openssl rand -hex 16\" makes one");
        }
        return new ListenToken(word, null);
    }

    /** Returns a sentence that says where a user of this computer finds the token. */
    String hint() {
        return file == null
                ? "the first line must be the token that the variable " + VARIABLE + " had at MAJIC's start"
                : "the first line must be the token that MAJIC printed at its start; it is also in " + file;
    }

    /** Compares in a time that does not reveal how much of the word is right. */
    boolean is(String said) {
        return MessageDigest.isEqual(word.getBytes(StandardCharsets.UTF_8), said.getBytes(StandardCharsets.UTF_8));
    }

    void delete() throws IOException {
        if (file != null) {
            Files.deleteIfExists(file);
        }
    }
}
