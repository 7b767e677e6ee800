package majic.program;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import majic.drivertest.TestClock;
import majic.environment.BotEnvironment;
import majic.environment.Settings;
import majic.shared.broker.BrokerAddress;
import majic.shared.broker.ConnectOptions;
import majic.shared.broker.FakeBroker;
import majic.shared.broker.FakeConnection;
import majic.shared.message.Sender;
import majic.team.Team;
import majic.team.TeamListener;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

/** Tests what a desk without robots says of the connection that the STOP of its site needs. */
class UsedSiteTest {
    private static final BrokerAddress LAB = BrokerAddress.parse("mqtt://broker/lab");

    @AutoClose
    private final TestClock clock = new TestClock();

    @AutoClose
    private final FakeBroker broker = new FakeBroker(clock.time());

    @AutoClose
    private final Team team = new Team(clock.time());

    private final List<String> said = new CopyOnWriteArrayList<>();
    private final FakeConnection connection =
            broker.open(ConnectOptions.of("user", new BotEnvironment(clock.time(), Settings.inMemory())));

    private UsedSite join() {
        team.addListener(new TeamListener() {
            @Override
            public void noticed(int robot, String message) {
                said.add(message);
            }
        });
        connection.connect();
        return new UsedSite(team, connection, LAB, Sender.ofThisRun("desk1", "Anna"));
    }

    private void loseAndRegain() {
        broker.stop();
        clock.until(() -> !connection.isConnected());
        broker.start();
        clock.until(connection::isConnected);
    }

    @Test
    @SuppressWarnings("try")
    void theLossAndTheReturnOfTheConnectionAreReported() {
        try (UsedSite site = join()) {
            loseAndRegain();

            clock.until(() -> said.size() == 2);
            assertThat(said.get(0))
                    .startsWith("the connection with the broker broker:1883 is lost (")
                    .endsWith("): until it is back, STOP of the site lab does not reach this desk");
            assertThat(said.get(1))
                    .isEqualTo("connected with the broker broker:1883 again: STOP of the site lab reaches this desk");
        }
    }

    @Test
    void aSiteThatWasLeftReportsNothing() {
        join().close();

        loseAndRegain();
        clock.until(() -> team.time().nanos() > 3_000_000_000L);

        assertThat(said).isEmpty();
    }
}
