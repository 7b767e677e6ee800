package majic.hemisson;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import majic.bot.BotEnvironment;
import majic.bot.LinkLost;
import majic.link.PseudoTerminal;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;

/** The driver over a real serial port of the system, with a RoadNarrows robot at the other end. */
@Timeout(20)
@DisabledOnOs(value = OS.WINDOWS, disabledReason = "Windows has no pseudo-terminals that are serial ports")
class MajicHemissonOnAPortTest {
    private final PseudoTerminal plug = new PseudoTerminal();
    private final List<String> heard = new CopyOnWriteArrayList<>();
    private final CountDownLatch moving = new CountDownLatch(1);
    private final MajicHemisson bot = new MajicHemisson(plug.name(), BotEnvironment.plain());
    private boolean pulled;

    @BeforeEach
    void plugIn() {
        Thread robot = new Thread(this::converse, "robot on a port");
        robot.setDaemon(true);
        robot.start();
        bot.connect();
    }

    @AfterEach
    void unplug() {
        bot.close();
        pull();
    }

    @Test
    void speaksTheRoadNarrowsDialect() {
        bot.move(10);

        assertThat(bot.get("version")).hasToString("HemiOS_v_1.50-RNe");
        assertThat(heard).containsSubsequence("D,2,2", "D,0,0", "E");
    }

    @Test
    void anAdapterPulledOutWhileItMovesSaysWhatAPersonCanDo() {
        new Thread(() -> {
                    awaitMotion();
                    pull();
                })
                .start();

        assertThatThrownBy(() -> bot.move(1000))
                .isInstanceOf(LinkLost.class)
                .hasMessageContaining("the serial port is gone")
                .hasMessageContaining("lift it");
    }

    @Test
    void closingTellsItToStand() {
        bot.drive(42, 0);
        awaitMotion();

        bot.close();

        assertThat(heard).endsWith("D,0,0", "E");
    }

    private void awaitMotion() {
        try {
            moving.await();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private synchronized void pull() {
        if (!pulled) {
            pulled = true;
            plug.close();
        }
    }

    private void converse() {
        StringBuilder command = new StringBuilder();
        try {
            while (true) {
                for (char next : plug.read().toCharArray()) {
                    if (next == '\r') {
                        answer(command.toString());
                        command.setLength(0);
                    } else {
                        command.append(next);
                    }
                }
            }
        } catch (IOException | RuntimeException e) {
            moving.countDown();
        }
    }

    private void answer(String command) {
        heard.add(command);
        if (command.startsWith("D") && !command.equals("D,0,0")) {
            moving.countDown();
        }
        plug.write(answerTo(command) + "\r\n");
    }

    private String answerTo(String command) {
        return switch (command) {
            case "B" -> "b,HemiOS_v_1.50-RNe";
            case "I" -> "i,1,1,1,1";
            case "N" -> "n,004,004,004,004,004,004,060,060";
            case "E" ->
                heard.stream()
                        .filter(said -> said.startsWith("D"))
                        .reduce("e,0,0", (before, said) -> "e" + said.substring(1));
            default -> command.startsWith("D") ? "d" + command.substring(1) : "<E01: unknown command>";
        };
    }
}
