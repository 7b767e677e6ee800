package majic.shared;

import majic.shared.broker.BrokerAddress;
import majic.shared.broker.BrokerConnection;
import majic.shared.message.Sender;

/** What a program does at each site of which it uses a robot, such as obeying the STOP of the whole team. */
@FunctionalInterface
public interface SiteObserver {
    /**
     * Begins with a site. Called on the thread that connects a robot, perhaps more than once for a site.
     *
     * @param connection an open connection, which the observer must not close
     * @param address the broker and the site
     * @param sender the sender of the requests
     * @return closed at {@link SharedType#leaveSites()}, or when no robot of the site could be connected; before the
     *     connection is
     */
    AutoCloseable begin(BrokerConnection connection, BrokerAddress address, Sender sender);
}
