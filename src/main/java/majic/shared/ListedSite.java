package majic.shared;

import majic.bot.BotException;
import majic.bot.BotProfile;
import majic.bot.ConnectFailed;
import majic.bot.ConnectFailed.Reason;
import majic.bot.Range;
import majic.bot.Value;
import majic.driver.BotDriver;
import majic.driver.Motion;
import majic.environment.BotEnvironment;
import majic.shared.broker.BrokerAddress;

/**
 * What an address of a whole site or desk stands for: connecting to it fails with a list of the robots that are shared
 * there. It can do nothing else.
 */
final class ListedSite extends BotDriver {
    private static final BotProfile NONE = new BotProfile(1, new Range(-1, 1), new Range(-1, 1), 1, 1, 1, true);

    private final BrokerAddress address;
    private final BrokerOpener opener;
    private final BotEnvironment environment;

    ListedSite(SharedType type, BrokerAddress address, BrokerOpener opener, BotEnvironment environment) {
        super(type, NONE, environment);
        this.address = address;
        this.opener = opener;
        this.environment = environment;
    }

    @Override
    protected void open() {
        SiteListing listing = new SiteListing(opener, address, environment);
        throw new ConnectFailed(Reason.OTHER, listing.question(listing.robots()));
    }

    @Override
    protected void shut() {}

    @Override
    protected Value moveBy(double mm, Motion motion) {
        throw notConnected();
    }

    @Override
    protected Value turnBy(double degrees, Motion motion) {
        throw notConnected();
    }

    @Override
    protected void driveAt(double mmPerSec, double degPerSec) {
        throw notConnected();
    }

    @Override
    protected void halt() {}

    private BotException notConnected() {
        return new BotException(address + " is no robot");
    }
}
