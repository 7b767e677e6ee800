package majic.panel;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.concurrent.CountDownLatch;
import javax.swing.JFrame;
import javax.swing.SwingUtilities;
import majic.bot.BotListener;
import majic.bot.BotState;
import majic.bot.FakeBot;
import majic.bot.FakeType;
import majic.bot.MajicBot;
import majic.environment.BotEnvironment;
import majic.gui.kit.EventThreadChecks;
import majic.time.WaitLimit;
import org.assertj.swing.edt.GuiActionRunner;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

class RefreshingPanelWindowTest {
    @AutoClose
    private final EventThreadChecks checks = new EventThreadChecks();

    private final FakeBot bot = new FakeBot(new FakeType(), BotEnvironment.plain());
    private final Counting panel = GuiActionRunner.execute(() -> new Counting(bot));
    private JFrame frame;

    @AfterEach
    void close() throws Exception {
        bot.close();
        SwingUtilities.invokeAndWait(frame::dispose);
    }

    @Test
    void newsAreShownOnceHoweverManyThereWere() throws Exception {
        SwingUtilities.invokeAndWait(() -> {
            frame = new JFrame();
            frame.add(panel);
            frame.pack();
            panel.refreshIfChanged();
        });
        checks.windowIsOpen();
        CountDownLatch delivered = new CountDownLatch(2);
        bot.addListener(new BotListener() {
            @Override
            public void connectionChanged(MajicBot changed, MajicBot.Connection connection) {
                delivered.countDown();
            }
        });
        bot.connect();
        WaitLimit.await("the changes of the connection", delivered);
        SwingUtilities.invokeAndWait(() -> {
            panel.refreshIfChanged();
            panel.refreshIfChanged();
        });
        assertThat(panel.refreshed).isEqualTo(2);
    }

    @Test
    void aPanelOutsideAWindowDoesNotListen() throws Exception {
        SwingUtilities.invokeAndWait(() -> {
            frame = new JFrame();
            frame.add(panel);
            frame.pack();
            panel.refreshIfChanged();
            frame.remove(panel);
        });
        checks.windowIsOpen();
        bot.connect();
        SwingUtilities.invokeAndWait(panel::refreshIfChanged);
        assertThat(panel.refreshed).isEqualTo(1);
        assertThat(panel.states).isZero();
    }

    private static final class Counting extends RefreshingPanel {
        private static final long serialVersionUID = 1;
        private int refreshed;
        private volatile int states;

        Counting(FakeBot bot) {
            super(bot);
        }

        @Override
        protected void refresh() {
            refreshed++;
        }

        @Override
        protected void stateReceived(BotState state) {
            states++;
        }
    }
}
