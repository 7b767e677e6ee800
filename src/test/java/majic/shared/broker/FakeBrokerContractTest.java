package majic.shared.broker;

import majic.time.TimeSource;
import org.junit.jupiter.api.AutoClose;

/** The broker in memory keeps the contract of real ones. */
class FakeBrokerContractTest extends BrokerContract {
    @AutoClose
    private final FakeBroker broker = new FakeBroker(TimeSource.system());

    @Override
    BrokerConnection open(ConnectOptions options) {
        return broker.open(options);
    }

    @Override
    void cut(BrokerConnection connection) {
        ((FakeConnection) connection).unplug();
    }

    @Override
    void restore(BrokerConnection connection) {
        ((FakeConnection) connection).restore();
    }
}
