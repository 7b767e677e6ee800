package majic.pioneer;

import java.util.function.Function;
import majic.bot.BotAddress;
import majic.environment.BotEnvironment;
import majic.pioneer.session.ConnectWait;
import majic.pioneer.session.PioneerConnection;

/** Makes drivers for tests of other packages. */
public final class TestPioneers {
    private TestPioneers() {}

    /** A driver over other connections than an address can name. */
    public static MajicPioneer over(Function<ConnectWait, PioneerConnection> connections, BotEnvironment environment) {
        BotAddress address = new BotAddress("pioneer", "//test");
        return new MajicPioneer(new PioneerAddress(address, null), connections, environment);
    }
}
