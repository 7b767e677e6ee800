package majicsim.net;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import majicsim.world.Noise;
import org.junit.jupiter.api.Test;

class LabTimeTest {
    private static final long STEP_NANOS = 4_000_000;

    private final LabTime time = new LabTime();
    private final List<String> runs = new ArrayList<>();

    @Test
    void aNewTaskRunsInTheNextStepAndThenOnlyWhenItIsDueAgain() {
        DueTime due = time.add(() -> run("task"));
        steps(3);
        due.atLatest(5 * STEP_NANOS);
        steps(3);
        assertThat(runs).containsExactly("task 4", "task 20");
    }

    @Test
    void theEarliestOfSeveralDueTimesCounts() {
        DueTime due = time.add(() -> run("task"));
        steps(1);
        due.atLatest(3 * STEP_NANOS);
        due.atLatest(2 * STEP_NANOS);
        due.atLatest(4 * STEP_NANOS);
        steps(4);
        assertThat(runs).containsExactly("task 4", "task 8");
    }

    @Test
    void aDueTimeBetweenTwoStepsMeansTheLaterOne() {
        DueTime due = time.add(() -> run("task"));
        steps(1);
        due.atLatest(2 * STEP_NANOS + 1);
        steps(2);
        assertThat(runs).containsExactly("task 4", "task 12");
    }

    @Test
    void tasksOfOneStepRunInTheOrderInWhichTheyWereAdded() {
        DueTime first = time.add(() -> run("first"));
        DueTime second = time.add(() -> run("second"));
        steps(1);
        second.atLatest(0);
        first.atLatest(0);
        steps(1);
        assertThat(runs).containsExactly("first 4", "second 4", "first 8", "second 8");
    }

    @Test
    void aTaskThatIsDueAtOnceAgainRunsInEachStep() {
        List<DueTime> due = new ArrayList<>();
        due.add(time.add(() -> {
            run("task");
            due.get(0).atLatest(0);
        }));
        steps(3);
        assertThat(runs).containsExactly("task 4", "task 8", "task 12");
    }

    @Test
    void anOrderedFaultLetsAllTasksRun() {
        time.add(() -> run("first"));
        time.add(() -> run("second"));
        steps(1);
        runs.clear();
        new Faults(Noise.exact(), time).outage(1);
        steps(2);
        assertThat(runs).containsExactly("first 8", "second 8");
    }

    private void steps(int count) {
        for (int i = 0; i < count; i++) {
            time.step(STEP_NANOS);
        }
    }

    private void run(String task) {
        runs.add(task + " " + time.nowNanos() / 1_000_000);
    }
}
