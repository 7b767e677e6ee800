package majic.gui;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

class ReconnectWindowTest {
    @AutoClose
    private final TestWindow window = TestWindow.openWith("robots.reconnect", "on");

    @Test
    void aLostRobotIsConnectedAgain() {
        ToyBot bot = window.add("//one");
        bot.loseLink();
        window.await("the connection", bot::isConnected);
        window.await("the end of the countdown", () -> !window.isShowing("reconnecting1"));
        assertThat(bot.told).noneMatch(command -> command.startsWith("move") || command.startsWith("drive"));
    }

    @Test
    void theCountdownIsShownAndCanBeCancelled() {
        ToyBot bot = window.add("//one");
        bot.refuseConnections();
        bot.loseLink();
        window.await(
                "the countdown",
                () -> window.isShowing("reconnecting1")
                        && window.text("reconnecting1").startsWith("reconnecting in"));
        window.push("cancelReconnect1");
        window.await("the end of the countdown", () -> !window.isShowing("reconnecting1"));
        window.await("the end of an attempt that was running", () -> window.isShowing("reconnect1"));
    }
}
