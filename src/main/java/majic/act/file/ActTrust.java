package majic.act.file;

import java.time.Instant;
import java.util.List;
import java.util.Optional;
import majic.environment.Settings;

/**
 * Stores which code the user has agreed to, by the hash of its file, in the user's settings. Acts that come with MAJIC,
 * and files without code, need no consent.
 *
 * @param settings the user's settings
 */
public record ActTrust(Settings settings) {
    private static final String KEY = "act.trusted.";

    /** Between the name, the time and the place, as they are stored. */
    private static final String SEPARATOR = "\t";

    /** Stored in place of a name; no act has this name. */
    private static final String TAKEN_BACK = "";

    /**
     * A consent to a file.
     *
     * @param act the name of the act
     * @param sha256 the hash of the whole file
     * @param since when the user agreed; empty for a consent of an earlier version of MAJIC
     * @param file where the file was then; empty if that is not known
     */
    public record Consent(String act, String sha256, Optional<Instant> since, String file) {
        private static Consent of(String sha256, String stored) {
            String[] parts = stored.split(SEPARATOR, -1);
            return parts.length < 3
                    ? new Consent(parts[0], sha256, Optional.empty(), "")
                    : new Consent(parts[0], sha256, Optional.of(Instant.parse(parts[1])), parts[2]);
        }
    }

    /**
     * Returns the consents that were given and not withdrawn.
     *
     * @return sorted by hash
     */
    public List<Consent> consents() {
        return settings.keys(KEY).stream()
                .map(key -> key.substring(KEY.length()))
                .filter(this::isAgreed)
                .map(sha256 -> Consent.of(sha256, settings.get(KEY + sha256).orElse("")))
                .toList();
    }

    /**
     * Returns whether a file may be loaded.
     *
     * @param file the file
     * @return true if it has no code of its own, came with MAJIC, or was agreed to before
     */
    public boolean isTrusted(ActFile file) {
        return !file.carriesCode() || file.isShipped() || isAgreed(file.sha256());
    }

    private boolean isAgreed(String sha256) {
        return settings.get(KEY + sha256)
                .filter(name -> !name.equals(TAKEN_BACK))
                .isPresent();
    }

    /**
     * Records that the user has seen the file's description and agrees to run its code, now and later. A file that
     * differs in any byte needs a new consent.
     *
     * @param file the file
     * @throws majic.bot.BotException if the change could not be saved; it is then valid until the program ends
     */
    public void agree(ActFile file) {
        agree(file, "");
    }

    /**
     * Does as {@link #agree(ActFile)}, and records where the file is.
     *
     * @param file the file
     * @param where its path; empty if it has none
     * @throws majic.bot.BotException if the change could not be saved; it is then valid until the program ends
     */
    public void agree(ActFile file, String where) {
        String name = file.details().name();
        settings.put(
                KEY + file.sha256(),
                String.join(
                        SEPARATOR,
                        (name.equals(TAKEN_BACK) ? file.actClass() : name).replace(SEPARATOR, " "),
                        Instant.now().toString(),
                        where.replace(SEPARATOR, " ")));
    }

    /**
     * Withdraws the consent to a file. A running act continues; the next load is refused.
     *
     * @param sha256 the hash of the whole file, 64 hexadecimal digits; the file itself may be gone
     * @return whether it had been agreed to
     * @throws majic.bot.BotException if the change could not be saved; it is then valid until the program ends
     */
    public boolean takeBack(String sha256) {
        boolean agreed = isAgreed(sha256);
        if (agreed) {
            settings.put(KEY + sha256, TAKEN_BACK);
        }
        return agreed;
    }
}
