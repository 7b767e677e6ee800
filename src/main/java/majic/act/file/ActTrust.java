package majic.act.file;

import majic.bot.Settings;

/**
 * Stores which code the user has agreed to, by the hash of its file, in the user's settings. Acts that come with MAJIC,
 * and files without code, need no consent.
 *
 * @param settings the user's settings
 */
public record ActTrust(Settings settings) {
    private static final String KEY = "act.trusted.";

    /** Stored in place of a name; no act has this name. */
    private static final String TAKEN_BACK = "";

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
        String name = file.details().name();
        settings.put(KEY + file.sha256(), name.equals(TAKEN_BACK) ? file.actClass() : name);
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
