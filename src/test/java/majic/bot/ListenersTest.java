package majic.bot;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import majic.time.TimeSource;
import majic.time.WaitPolicy;
import org.junit.jupiter.api.Test;

/** Tests which listeners receive the notices of a robot, and when. */
class ListenersTest {
    private final Listeners listeners = new Listeners(FakeBot.on(TimeSource.system()), TimeSource.system());
    private final List<String> first = new ArrayList<>();
    private final List<String> second = new ArrayList<>();

    @Test
    void aNoticeBeforeThereIsAListenerIsKeptForTheFirst() {
        listeners.notice("the switches are wrong");
        listeners.add(into(first));
        listeners.add(into(second));

        assertThat(first).containsExactly("the switches are wrong");
        assertThat(second).isEmpty();
    }

    @Test
    void laterNoticesReachAllListeners() {
        listeners.add(into(first));
        listeners.add(into(second));
        listeners.notice("it stands");

        assertThat(first).containsExactly("it stands");
        assertThat(second).containsExactly("it stands");
    }

    @Test
    void aListenerThatFailsDoesNotKeepOthersFromBeingCalled() {
        listeners.add(new BotListener() {
            @Override
            public void notice(MajicBot bot, String message) {
                throw new IllegalStateException("a bad listener");
            }
        });
        listeners.add(into(first));
        listeners.notice("it stands");

        assertThat(first).containsExactly("it stands");
    }

    @Test
    void aListenerReceivesNoEventFromBeforeItWasAdded() {
        List<MajicBot.Connection> received = new ArrayList<>();
        WaitPolicy.without(() -> {
            listeners.connectionChanged(MajicBot.Connection.CONNECTED);
            listeners.deliver();
        });
        listeners.add(new BotListener() {
            @Override
            public void connectionChanged(MajicBot bot, MajicBot.Connection connection) {
                received.add(connection);
            }
        });
        listeners.deliver();

        assertThat(received).isEmpty();
    }

    private static BotListener into(List<String> heard) {
        return new BotListener() {
            @Override
            public void notice(MajicBot bot, String message) {
                heard.add(message);
            }
        };
    }
}
