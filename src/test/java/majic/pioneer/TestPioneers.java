package majic.pioneer;

import java.util.function.Function;
import majic.environment.BotEnvironment;
import majic.pioneer.session.ConnectWait;
import majic.pioneer.session.PioneerConnection;

/** Makes drivers for tests of other packages. */
public final class TestPioneers {
    private TestPioneers() {}

    /** A driver over other connections than an address can name. */
    public static MajicPioneer over(Function<ConnectWait, PioneerConnection> connections, BotEnvironment environment) {
        return new MajicPioneer(connections, environment);
    }
}
