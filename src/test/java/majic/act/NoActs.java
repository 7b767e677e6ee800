package majic.act;

import java.nio.file.Path;
import majic.act.file.ActTrust;
import majic.act.file.Acts;
import majic.bot.Settings;

/** For sessions whose user has no behaviours of his own and has agreed to nothing. */
public final class NoActs {
    private NoActs() {}

    /** Those that come with MAJIC. */
    public static Acts here() {
        return new Acts(Path.of("no", "such", "folder"), new ActTrust(Settings.inMemory()));
    }
}
