package majic.driver;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import majic.bot.BotListener;
import majic.bot.FakeBot;
import majic.bot.MajicBot;
import majic.bot.MajicBot.Connection;
import majic.time.TimeSource;
import majic.time.WaitLimit;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** A listener for connection changes may call any method, and receives every change in order. */
class ConnectionNewsTest implements BotListener {
    @AutoClose
    private final FakeBot bot = FakeBot.on(TimeSource.system());

    private final BlockingQueue<Connection> heard = new LinkedBlockingQueue<>();
    private volatile Runnable whenLost = () -> {};

    @BeforeEach
    void connect() {
        bot.connect();
        bot.addListener(this);
    }

    @Override
    public void connectionChanged(MajicBot changed, Connection connection) {
        if (connection == Connection.LOST) {
            whenLost.run();
        }
        heard.add(connection);
    }

    @Test
    void aListenerMayWaitForAThreadThatClosesTheRobot() throws InterruptedException {
        whenLost = () -> CompletableFuture.runAsync(bot::close, task -> new Thread(task).start())
                .orTimeout(WaitLimit.SECONDS, TimeUnit.SECONDS)
                .join();

        bot.cut();

        assertThat(next(2)).containsExactly(Connection.LOST, Connection.CLOSED);
    }

    @Test
    void aListenerMayConnectAgainAtOnce() throws InterruptedException {
        whenLost = bot::connect;

        bot.cut();

        assertThat(next(3)).containsExactly(Connection.LOST, Connection.CONNECTING, Connection.CONNECTED);
        assertThat(bot.isConnected()).isTrue();
    }

    /** Waits for the next changes, which the robot's thread for listeners may deliver too. */
    private List<Connection> next(int count) throws InterruptedException {
        List<Connection> changes = new ArrayList<>();
        while (changes.size() < count) {
            changes.add(Objects.requireNonNull(heard.poll(WaitLimit.SECONDS, TimeUnit.SECONDS), "a further change"));
        }
        return changes;
    }
}
