package majic.server;

import java.lang.System.Logger.Level;
import java.net.InetAddress;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.LongSupplier;
import majic.script.MajicParser;
import org.jspecify.annotations.Nullable;

/**
 * Decides by its first line whether a client may command the team. A web page can make a browser connect, but the
 * browser's first line is neither the token nor MAJIC Script. Used by one thread.
 */
final class Admission {
    /** Maximum number of wrong tokens a minute from one address of another computer. */
    static final int WRONG_TOKENS_PER_MINUTE = 10;

    private static final System.Logger LOG = System.getLogger(Admission.class.getName());
    private static final int MOST_ADDRESSES = 1000;
    private static final String ALL = "all";

    private final @Nullable ListenToken token;
    private final LongSupplier nanos;

    /** Remaining attempts, for the addresses of other computers from which a wrong token came. */
    private final Map<InetAddress, Rate> attempts = new LinkedHashMap<>();

    Admission(@Nullable ListenToken token, LongSupplier nanos) {
        this.token = token;
        this.nanos = nanos;
    }

    Optional<ListenToken> token() {
        return Optional.ofNullable(token);
    }

    /**
     * Checks the first line of a client.
     *
     * @param line the line
     * @param from the client's address
     * @param parser reads the line as MAJIC Script
     * @return why the client is refused; empty if it is admitted
     */
    Optional<String> refusal(String line, InetAddress from, MajicParser parser) {
        if (token == null) {
            return isRequestForAll(line) || parser.isScript(line)
                    ? Optional.empty()
                    : Optional.of("the first line must be MAJIC Script, for instance: bots");
        }
        if (isExhausted(from)) {
            return Optional.of("too many wrong tokens came from this address; wait a minute");
        }
        if (isToken(token, line)) {
            return Optional.empty();
        }
        LOG.log(Level.WARNING, "a client at {0} sent a wrong token", from.getHostAddress());
        if (from.isLoopbackAddress()) {
            return Optional.of(token.hint());
        }
        attempts(from).take();
        return Optional.of(ListenToken.HINT);
    }

    private static boolean isToken(ListenToken token, String line) {
        String[] words = line.strip().split("\\s+", 2);
        return token.is(words[0]) && (words.length == 1 || isAll(words[1]));
    }

    /** Returns whether an admitted client's first line asks for the answers to all clients. */
    boolean receivesAll(String line) {
        String[] words = line.strip().split("\\s+", 2);
        return token == null ? isRequestForAll(line) : words.length > 1 && isAll(words[1]);
    }

    /** Returns whether an admitted client's first line is a line of MAJIC Script. */
    boolean isScript(String line) {
        return token == null && !isRequestForAll(line);
    }

    private static boolean isRequestForAll(String line) {
        return isAll(line.strip());
    }

    private static boolean isAll(String word) {
        return word.toLowerCase(Locale.ROOT).equals(ALL);
    }

    private boolean isExhausted(InetAddress from) {
        Rate left = attempts.get(from);
        return left != null && !left.hasOne();
    }

    private Rate attempts(InetAddress from) {
        if (attempts.size() >= MOST_ADDRESSES && !attempts.containsKey(from)) {
            attempts.remove(attempts.keySet().iterator().next());
        }
        return attempts.computeIfAbsent(
                from, key -> new Rate(WRONG_TOKENS_PER_MINUTE, WRONG_TOKENS_PER_MINUTE / 60.0, nanos));
    }
}
