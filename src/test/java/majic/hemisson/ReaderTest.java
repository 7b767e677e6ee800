package majic.hemisson;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import majic.bot.BotListener;
import majic.bot.BotState;
import majic.bot.MajicBot;
import org.junit.jupiter.api.Test;

/** The thread that reads the robot's line, and what listeners and errors do to it. */
class ReaderTest {
    private static final int ROUNDS = 5;

    @Test
    void aListenerThatReadsAnUnpolledValueDelaysNeitherTheLineNorAStop() throws IOException {
        List<Long> waits = new CopyOnWriteArrayList<>();
        try (DrivenHemisson pair = new DrivenHemisson()) {
            MajicHemisson bot = pair.bot();
            bot.addListener(new BotListener() {
                @Override
                public void stateChanged(MajicBot source, BotState state) {
                    if (waits.size() < ROUNDS) {
                        long before = bot.time().nanos();
                        bot.get("tvRemote");
                        bot.set("ledLeft", "on");
                        bot.stop();
                        waits.add(bot.time().nanos() - before);
                    }
                }
            });
            bot.connect();
            pair.await(() -> waits.size() == ROUNDS);

            bot.stop();

            assertThat(waits).containsOnly(0L);
            pair.await(() -> pair.robot().count("T") > 0);
            assertThat(pair.robot().count("L,0,0,1,0")).isPositive();
            assertThat(bot.isConnected()).isTrue();
        }
    }
}
