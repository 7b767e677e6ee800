package majic.driver;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;
import majic.bot.BotListener;
import majic.bot.FakeBot;
import majic.bot.MajicBot;
import majic.bot.MajicBot.Connection;
import majic.time.TimeSource;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** A listener for connection changes may call any method, and receives every change in order. */
class ConnectionNewsTest implements BotListener {
    @AutoClose
    private final FakeBot bot = FakeBot.on(TimeSource.system());

    private final List<Connection> heard = new CopyOnWriteArrayList<>();
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
    void aListenerMayWaitForAThreadThatClosesTheRobot() {
        whenLost = () -> CompletableFuture.runAsync(bot::close, task -> new Thread(task).start())
                .orTimeout(10, TimeUnit.SECONDS)
                .join();

        bot.cut();

        assertThat(heard).containsExactly(Connection.LOST, Connection.CLOSED);
    }

    @Test
    void aListenerMayConnectAgainAtOnce() {
        whenLost = bot::connect;

        bot.cut();

        assertThat(heard).containsExactly(Connection.LOST, Connection.CONNECTING, Connection.CONNECTED);
        assertThat(bot.isConnected()).isTrue();
    }
}
