package majic.pioneer;

import java.util.List;
import java.util.function.Function;
import majic.bot.BotAddress;
import majic.bot.BotException;
import majic.environment.BotEnvironment;
import majic.link.LinkAddress;
import majic.pioneer.line.ArcosConnection;
import majic.pioneer.line.BaudRates;
import majic.pioneer.session.ConnectWait;
import majic.pioneer.session.ConnectionMaker;
import majic.pioneer.session.PioneerConnection;
import majic.vendor.VendorLibrary;

/** Chooses by a robot's address what connects to it: the driver's own client, or a library. */
final class PioneerConnections {
    static final List<String> LIBRARIES = List.of(VendorLibrary.ARIA.word());

    private static final String ARIA_ADAPTER = "majic.pioneer.aria.AriaConnections";

    private PioneerConnections() {}

    /**
     * Returns what makes the connection of each session.
     *
     * @throws BotException if it is no Pioneer's address, or the library that it names is missing
     */
    static Function<ConnectWait, PioneerConnection> of(BotAddress address, BotEnvironment environment) {
        LinkAddress robot = robot(address);
        if (address.libraryAmong(LIBRARIES).isEmpty()) {
            return wait -> new ArcosConnection(robot.newLink(), wait);
        }
        ConnectionMaker maker = VendorLibrary.ARIA.create(ConnectionMaker.class, ARIA_ADAPTER, environment.settings());
        return wait -> maker.make(robot.newLink().address(), wait);
    }

    private static LinkAddress robot(BotAddress address) {
        if (!address.type().equals("pioneer")) {
            throw new BotException(
                    address + ": not a Pioneer's address; it looks like pioneer://10.0.0.5 or pioneer:/dev/ttyS0");
        }
        try {
            return LinkAddress.of(address.rest(), PioneerType.PORT, BaudRates.POWER_UP);
        } catch (IllegalArgumentException e) {
            throw new BotException(address.scheme() + ":" + e.getMessage(), e);
        }
    }
}
