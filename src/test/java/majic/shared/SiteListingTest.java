package majic.shared;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.stream.IntStream;
import majic.bot.BotProfile;
import majic.bot.Range;
import majic.drivertest.TestClock;
import majic.environment.BotEnvironment;
import majic.environment.Settings;
import majic.shared.broker.BrokerAddress;
import majic.shared.broker.BrokerConnection;
import majic.shared.broker.BrokerMessage;
import majic.shared.broker.ConnectOptions;
import majic.shared.broker.FakeBroker;
import majic.shared.broker.Mosquitto;
import majic.shared.broker.Quality;
import majic.shared.message.Description;
import majic.shared.message.Presence;
import majic.shared.message.Presence.State;
import majic.shared.message.Sender;
import majic.shared.message.SiteTopics;
import majic.shared.message.SiteTopics.Part;
import majic.time.TimeSource;
import majic.time.WaitLimit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.junit.jupiter.api.io.TempDir;

/** Tests the list of the robots that are shared at a site. */
class SiteListingTest {
    private static final SiteTopics TOPICS = new SiteTopics("lab");
    private static final BrokerAddress ADDRESS = BrokerAddress.parse("mqtt://broker/lab");

    static boolean isInstalled() {
        return Mosquitto.installed().isPresent();
    }

    private static BrokerMessage presence(State state, String desk, int robots) {
        Presence presence = new Presence(
                state,
                new Sender(desk, "Bert", "s-" + desk),
                "MAJIC",
                IntStream.rangeClosed(1, robots).boxed().toList());
        return BrokerMessage.json(TOPICS.presence(desk), presence.toJson(), Quality.AT_LEAST_ONCE)
                .retain();
    }

    private static BrokerMessage description(String desk, int robot, String session) {
        Description pioneer = new Description(
                session,
                "",
                new Description.Kind("pioneer", "Pioneer", "MobileRobots Pioneer"),
                "a MobileRobots Pioneer",
                new BotProfile(250, Range.ANY, Range.ANY, 100, 45, 300, false),
                false,
                List.of(),
                List.of(),
                List.of(),
                List.of());
        return BrokerMessage.json(TOPICS.robot(desk, robot, Part.DESCRIPTION), pioneer.toJson(), Quality.AT_LEAST_ONCE)
                .retain();
    }

    @Test
    void leavesOutRobotsOfDesksThatAreGoneAndOfEarlierRuns() {
        try (TestClock clock = new TestClock();
                FakeBroker broker = new FakeBroker(clock.time())) {
            broker.publish(presence(State.ONLINE, "desk2", 2));
            broker.publish(description("desk2", 1, "s-desk2"));
            broker.publish(description("desk2", 2, "of an earlier run"));
            broker.publish(description("desk2", 3, "s-desk2"));
            broker.publish(presence(State.BROKEN, "desk9", 0));
            broker.publish(description("desk9", 1, "s-desk9"));
            BotEnvironment environment = new BotEnvironment(clock.time(), Settings.inMemory());
            SiteListing listing = new SiteListing((address, options) -> broker.open(options), ADDRESS, environment);

            Map<String, String> robots = listing.robots();

            assertThat(robots)
                    .containsExactly(
                            Map.entry("mqtt://broker/lab/desk2/1", "MobileRobots Pioneer"),
                            Map.entry("mqtt://broker/lab/desk2/2", "no description has arrived"));
            assertThat(listing.question(robots)).endsWith("; desk9 has no connection with the broker?");
        }
    }

    @Test
    void asksAgainForWhatTheBrokerLeavesOutAsLongAsThatHelps() {
        try (TestClock clock = new TestClock();
                FakeBroker broker = new FakeBroker(clock.time())) {
            broker.publish(presence(State.ONLINE, "desk2", 3));
            for (int robot = 1; robot <= 3; robot++) {
                broker.publish(description("desk2", robot, "s-desk2"));
                broker.leaveOut(TOPICS.robot("desk2", robot, Part.DESCRIPTION), robot - 1);
            }
            BotEnvironment environment = new BotEnvironment(clock.time(), Settings.inMemory());

            Map<String, String> robots =
                    new SiteListing((address, options) -> broker.open(options), ADDRESS, environment).robots();

            assertThat(robots)
                    .hasSize(3)
                    .allSatisfy((robot, what) -> assertThat(what).isEqualTo("MobileRobots Pioneer"));
        }
    }

    @Test
    @EnabledIf("isInstalled")
    void isCompleteWithMoreRobotsThanMosquittoQueues(@TempDir Path folder) throws InterruptedException {
        BotEnvironment environment = new BotEnvironment(TimeSource.system(), Settings.inMemory());
        try (Mosquitto mosquitto = Mosquitto.start(folder)) {
            BrokerAddress address = BrokerAddress.parse("mqtt://127.0.0.1:" + mosquitto.port() + "/lab");
            try (BrokerConnection desk = BrokerConnection.open(
                    address, ConnectOptions.of("desk", environment).withTimeoutMs(WaitLimit.MS))) {
                desk.connect();
                CountDownLatch open = new CountDownLatch(1800);
                for (String name : List.of("desk1", "desk2")) {
                    for (int robot = 1; robot <= 900; robot++) {
                        desk.publish(description(name, robot, "s-" + name), problem -> open.countDown());
                    }
                    desk.publish(presence(State.ONLINE, name, 900));
                }
                open.await(WaitLimit.SECONDS, TimeUnit.SECONDS);

                assertThat(new SiteListing(BrokerConnection::open, address, environment).robots())
                        .hasSize(1800)
                        .allSatisfy((robot, what) -> assertThat(what).isEqualTo("MobileRobots Pioneer"));
            }
        }
    }
}
