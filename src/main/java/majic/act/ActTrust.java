package majic.act;

import majic.bot.Settings;

/**
 * Which code the user has agreed to, remembered by the hash of its file in the user's settings. Acts that come with
 * MAJIC, and files without code, need no consent.
 *
 * @param settings where it is remembered
 */
public record ActTrust(Settings settings) {
    private static final String KEY = "act.trusted.";

    /**
     * Whether a file may be loaded.
     *
     * @param file the file
     * @return true if it has no code of its own, came with MAJIC, or was agreed to before
     */
    public boolean isTrusted(ActFile file) {
        return !file.carriesCode()
                || file.isShipped()
                || settings.get(KEY + file.sha256()).isPresent();
    }

    /**
     * The user has seen what the file says of itself and agrees to run its code, now and later. Another file, however
     * alike, is asked for anew.
     *
     * @param file the file
     * @throws majic.bot.BotException if that could not be written down; it then holds until the program ends
     */
    public void agree(ActFile file) {
        settings.put(KEY + file.sha256(), file.details().name());
    }
}
