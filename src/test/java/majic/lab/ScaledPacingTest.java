package majic.lab;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class ScaledPacingTest {
    private static final long MS = 1_000_000;
    private static final long STEP = 4 * MS;

    private final List<String> reports = new ArrayList<>();
    private long realNanos;
    private long labNanos;
    private boolean quiet = true;
    private boolean membersWait = true;

    @Test
    void theLabFollowsTheWallClock() {
        Pacing pacing = pacing(1);
        run(pacing, 1000);
        assertThat(labNanos).isBetween(980 * MS, 1024 * MS);
    }

    @Test
    void theSpeedMultipliesTheWallClock() {
        Pacing pacing = pacing(20);
        run(pacing, 1000);
        assertThat(labNanos).isBetween(19_900 * MS, 20_100 * MS);
    }

    @Test
    void aFastLabThatWasHeldUpMakesUpForAFifthOfASecondOfItsTime() {
        Pacing pacing = pacing(20);
        run(pacing, 1000);
        long before = labNanos;
        realNanos += 5000 * MS;

        assertThat(stepsAtOnce(pacing) * STEP).isBetween(180 * MS, 220 * MS);
        assertThat(labNanos).isGreaterThan(before);
    }

    @Test
    void aFastLabWaitsForBytesInTransit() {
        Pacing pacing = pacing(20);
        run(pacing, 1000);
        quiet = false;
        long before = labNanos;
        run(pacing, 200);

        assertThat(labNanos - before).isLessThanOrEqualTo(100 * MS);
        quiet = true;
        run(pacing, 100);
        assertThat(labNanos - before).isGreaterThan(1900 * MS);
    }

    @Test
    void aFastLabWaitsForMembersThatRun() {
        Pacing pacing = pacing(20);
        run(pacing, 1000);
        membersWait = false;
        long before = labNanos;
        run(pacing, 200);

        assertThat(labNanos - before).isLessThanOrEqualTo(100 * MS);
    }

    @Test
    void bytesThatAreNeverReadDoNotEndTheLab() {
        Pacing pacing = pacing(20);
        run(pacing, 1000);
        quiet = false;
        long before = labNanos;
        run(pacing, 1000);

        assertThat(labNanos - before).isBetween(300 * MS, 600 * MS);
    }

    @Test
    void atRealTimeNothingIsWaitedFor() {
        Pacing pacing = pacing(1);
        quiet = false;
        membersWait = false;
        run(pacing, 1000);
        assertThat(labNanos).isBetween(980 * MS, 1024 * MS);
    }

    @Test
    void aLabThatIsTooSlowReportsOnceAtWhichSpeedItRuns() {
        Pacing pacing = pacing(50);
        for (int step = 0; step < 20_000; step++) {
            pacing.mayStep(labNanos, () -> true);
            labNanos += STEP;
            realNanos += 2 * MS;
        }
        assertThat(reports)
                .containsExactly("this computer is too slow or too busy for the simulated lab: it runs at 2 times real"
                        + " time, not at 50 times; nothing is left out, it only takes longer");
    }

    @Test
    void aLabThatKeepsUpReportsNothing() {
        run(pacing(10), 60_000);
        assertThat(reports).isEmpty();
    }

    private Pacing pacing(double speed) {
        return new ScaledPacing(speed, () -> quiet, new SpeedWatch(speed, reports::add), new ScaledPacing.RealTime() {
            @Override
            public long nanos() {
                return realNanos;
            }

            @Override
            public void pause(long nanos) {
                realNanos += nanos;
            }
        });
    }

    /** Steps until so much real time has passed; a step takes none. */
    private void run(Pacing pacing, long realMs) {
        long end = realNanos + realMs * MS;
        while (realNanos < end) {
            if (pacing.mayStep(labNanos, () -> membersWait)) {
                labNanos += STEP;
            }
        }
    }

    private int stepsAtOnce(Pacing pacing) {
        long now = realNanos;
        int steps = 0;
        while (pacing.mayStep(labNanos, () -> membersWait) && realNanos == now) {
            labNanos += STEP;
            steps++;
        }
        return steps;
    }
}
