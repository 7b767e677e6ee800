package majic.act;

import java.nio.file.Path;
import majic.act.file.ActCatalog;
import majic.act.file.ActTrust;
import majic.environment.Settings;

/** Provides the behaviours for sessions without behaviours of the user and without consents. */
public final class NoActs {
    private NoActs() {}

    /** Returns the behaviours that come with MAJIC. */
    public static ActCatalog here() {
        return new ActCatalog(Path.of("no", "such", "folder"), new ActTrust(Settings.inMemory()));
    }
}
