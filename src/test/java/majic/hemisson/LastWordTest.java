package majic.hemisson;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;

/** A program of its own, ended by the system while its robot moves. */
@Timeout(120)
@DisabledOnOs(value = OS.WINDOWS, disabledReason = "Windows has no pseudo-terminals that are serial ports")
class LastWordTest {
    /** Drives a metre and never closes anything. */
    static final class Program {
        private Program() {}

        @SuppressWarnings("resource")
        public static void main(String[] args) {
            MajicHemisson bot = new MajicHemisson("hemisson:" + args[0]);
            bot.connect();
            bot.move(1000);
        }
    }

    @Test
    void aProgramThatIsEndedInMidMotionTellsTheRobotToStand() throws Exception {
        try (PortHemisson robot = PortHemisson.stock()) {
            Process program = start(robot.name());
            robot.awaitMotion();

            program.destroy();
            assertThat(program.waitFor(30, TimeUnit.SECONDS)).isTrue();

            robot.awaitStop();
            assertThat(robot.heard()).containsSubsequence("D,3,3", "D,0,0", "E");
        }
    }

    private static Process start(String port) throws IOException {
        return new ProcessBuilder(
                        System.getProperty("java.home") + "/bin/java",
                        "-cp",
                        System.getProperty("java.class.path"),
                        Program.class.getName(),
                        port)
                .redirectErrorStream(true)
                .redirectOutput(ProcessBuilder.Redirect.DISCARD)
                .start();
    }
}
