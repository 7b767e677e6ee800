package majic.shared;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import majic.bot.BotListener;
import majic.bot.MajicBot;
import majic.bot.Unit;
import majic.bot.Value;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

/** Tests the delay of a shared robot: it is measured, and the user is warned once of a long one. */
class DelayTest {
    @AutoClose
    private final SharedLabRobot pioneer = new SharedLabRobot("pioneer");

    private final List<String> notices = Collections.synchronizedList(new ArrayList<>());

    private void connect() {
        pioneer.bot().addListener(new BotListener() {
            @Override
            public void notice(MajicBot bot, String message) {
                notices.add(message);
            }
        });
        pioneer.bot().connect();
    }

    @Test
    void isMeasuredFromARequestToItsAnswer() throws InterruptedException {
        connect();
        assertThat(pioneer.bot().get("delay")).isInstanceOf(Value.Unknown.class);

        pioneer.bot().time().sleep(1);

        assertThat(pioneer.bot().get("delay")).isInstanceOfSatisfying(Value.Number.class, delay -> {
            assertThat(delay.unit()).isEqualTo(Unit.MS);
            assertThat(delay.amount()).isBetween(0.0, 20.0);
        });
        assertThat(notices).isEmpty();
    }

    @Test
    void isWarnedOfOnceWhenItStaysLong() throws InterruptedException {
        connect();
        for (int second = 0; second < 60; second++) {
            pioneer.holdUserBack();
            pioneer.bot().time().sleep(0.9);
            pioneer.deliverToUser();
            pioneer.bot().time().sleep(0.02);
        }

        assertThat(notices).hasSize(1).first().asString().contains("more than 300 ms");
    }
}
