package majic.hemisson;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import majic.bot.MajicBot;
import majic.inlab.LabRig;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

/** A Hemisson of the lab behind a serial server that delays what both send. */
class HemissonOnASlowLineTest {
    private static final Pattern FAILED =
            Pattern.compile("1 move 100: failed: .* instead of .*, after about (\\d+) mm");

    @AutoClose
    private final LabRig rig = LabRig.exact();

    private final MajicBot robot = rig.add("hemisson");

    @Test
    void aReadingCountsFromWhenItWasAskedFor() throws InterruptedException {
        delay(200);

        rig.lab().time().sleep(3);

        assertThat(robot.get("age").number()).isBetween(400.0, 1000.0);
    }

    @Test
    void aMotionWhoseStopIsDelayedIsNotDone() throws InterruptedException {
        rig.after(0.6, () -> delay(300));

        List<String> said = rig.run("1 move 100");

        Matcher failed = FAILED.matcher(said.get(said.size() - 1));
        assertThat(failed.matches()).as(said.toString()).isTrue();
        assertThat(Double.parseDouble(failed.group(1)))
                .isGreaterThan(106)
                .isEqualTo(Math.rint(robot.state().pose().xMm()));
    }

    @Test
    void aMotionOnALineWithASteadyDelayIsDone() throws InterruptedException {
        delay(200);
        double fromMm = rig.truePose("hemisson").xMm();

        assertThat(rig.run("1 move 100")).anyMatch(line -> line.startsWith("1 move 100: done (about 100 mm"));
        assertThat(rig.truePose("hemisson").xMm() - fromMm).isCloseTo(100, within(3.0));
    }

    private void delay(double ms) {
        rig.lab().simulators().faults("hemisson").delay(ms);
    }
}
