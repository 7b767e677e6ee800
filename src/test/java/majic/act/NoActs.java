package majic.act;

import java.nio.file.Path;
import majic.act.file.ActTrust;
import majic.act.file.Acts;
import majic.bot.Settings;

/** Provides the behaviours for sessions without behaviours of the user and without consents. */
public final class NoActs {
    private NoActs() {}

    /** Returns the behaviours that come with MAJIC. */
    public static Acts here() {
        return new Acts(Path.of("no", "such", "folder"), new ActTrust(Settings.inMemory()));
    }
}
