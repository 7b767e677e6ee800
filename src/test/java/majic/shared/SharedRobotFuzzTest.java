package majic.shared;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import com.code_intelligence.jazzer.junit.FuzzTest;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.BooleanSupplier;
import majic.bot.BotAddress;
import majic.bot.BotException;
import majic.bot.BotListener;
import majic.bot.MajicBot;
import majic.bot.Parameter;
import majic.bot.RangeScan;
import majic.drivertest.TestClock;
import majic.environment.BotEnvironment;
import majic.environment.Settings;
import majic.shared.broker.BrokerMessage;
import majic.shared.broker.FakeBroker;
import majic.shared.broker.Quality;
import majic.shared.message.Presence;
import majic.shared.message.Sender;
import majic.shared.message.SiteTopics;
import majic.shared.message.SiteTopics.Part;
import majic.text.OneSentence;
import majic.text.VisibleText;
import majic.time.Signal;

/**
 * Arbitrary robots of another desk: kept inputs in every build, new ones with {@code mvn -Pfuzz test} (see
 * CONTRIBUTING.md).
 */
class SharedRobotFuzzTest {
    private static final SiteTopics TOPICS = new SiteTopics("lab");
    private static final String DESK = "desk2";
    private static final double PERIOD_S = 0.5;

    /** A description, a state, a scan and a message for users, one in each line. */
    @FuzzTest
    void anyRobotIsConnectedOrRefusedInOneSentence(byte[] lines) {
        String[] published = (new String(lines, UTF_8) + "\n\n\n").split("\n", 4);
        try (TestClock clock = new TestClock();
                FakeBroker broker = new FakeBroker(clock.time())) {
            SharedType type = new SharedType((address, options) -> broker.open(options));
            broker.publish(presence());
            broker.publish(message(Part.DESCRIPTION, published[0]).retain());
            AtomicBoolean reporting = new AtomicBoolean(true);
            Signal ended = clock.time().signal();
            CompletableFuture<Void> reports = clock.aside(() -> {
                do {
                    broker.publish(message(Part.STATE, published[1]));
                    broker.publish(message(Part.SCANS, published[2]));
                    broker.publish(message(Part.MESSAGES, published[3]));
                } while (!await(ended, () -> !reporting.get()));
            });
            BotEnvironment environment = new BotEnvironment(clock.time(), Settings.inMemory());
            try (MajicBot bot = type.create(BotAddress.parse("mqtt://broker/lab/desk2/1"), environment)) {
                use(bot);
            }
            reporting.set(false);
            ended.raise();
            clock.join(reports);
        }
    }

    private static void use(MajicBot bot) {
        List<String> notices = new CopyOnWriteArrayList<>();
        List<RangeScan> scans = new CopyOnWriteArrayList<>();
        bot.addScanListener(scans::add);
        bot.addListener(new BotListener() {
            @Override
            public void notice(MajicBot from, String message) {
                notices.add(message);
            }
        });
        try {
            bot.connect();
        } catch (BotException e) {
            OneSentence.check(VisibleText.of(String.valueOf(e.getMessage())));
            return;
        }
        assertThat(bot.parameters()).allSatisfy(parameter -> read(bot, parameter));
        assertThat(bot.commands())
                .allSatisfy(command -> assertThat(command.usage()).isNotNull());
        assertThat(bot.displayState()).isNotNull();
        assertThat(bot.type().label()).isNotNull();
        assertThat(bot.introduction()).isNotNull();
        await(bot.time().signal(), () -> false);
        assertThat(notices).doesNotContainNull();
        assertThat(scans).extracting(RangeScan::sensor).isSubsetOf(bot.rangeSensors());
    }

    private static void read(MajicBot bot, Parameter parameter) {
        try {
            assertThat(bot.get(parameter.name()).toString()).isNotNull();
        } catch (BotException e) {
            assertThat(e.getMessage()).isNotBlank();
        }
    }

    private static BrokerMessage presence() {
        Presence online = new Presence(Presence.State.ONLINE, Sender.ofThisRun(DESK, "Bob"), "MAJIC", List.of(1));
        return BrokerMessage.json(TOPICS.presence(DESK), online.toJson(), Quality.AT_LEAST_ONCE)
                .retain();
    }

    private static BrokerMessage message(Part part, String payload) {
        return BrokerMessage.json(TOPICS.robot(DESK, 1, part), payload, Quality.AT_MOST_ONCE);
    }

    /** Returns whether a condition is true within a period. */
    private static boolean await(Signal signal, BooleanSupplier condition) {
        try {
            return signal.await(condition, PERIOD_S);
        } catch (InterruptedException e) {
            throw new IllegalStateException(e);
        }
    }
}
