package majic.stop;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.OptionalInt;
import java.util.concurrent.Callable;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import majic.bot.MajicBot;
import majic.bot.Pose;
import majic.environment.Settings;
import majic.program.Plugins;
import majic.simulation.SimulatedLab;
import majic.team.Answer;
import majic.team.BotFactory;
import majic.team.Team;
import majic.team.TeamListener;
import majic.time.TimeSource;
import majicsim.LabOptions;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** Tests STOP with twenty robots of ten labs, half of which no longer read the data sent to them. */
class StopOfManyRobotsTest {
    private static final int LABS = 10;
    private static final int STUCK = 5;
    private static final int ROBOTS = 20;

    private final List<SimulatedLab> labs = new ArrayList<>();
    private final Team team = new Team(TimeSource.system());
    private final List<Answer> answers = Collections.synchronizedList(new ArrayList<>());
    private final CountDownLatch answered = new CountDownLatch(ROBOTS);

    @AfterEach
    void close() {
        team.close();
        labs.forEach(SimulatedLab::close);
    }

    @Test
    void reachesEveryRobotThatCanBeReachedAndAnswersForAll() throws Exception {
        List<MajicBot> bots = connectAll();
        bots.forEach(bot -> bot.drive(100, 0));
        labs.subList(0, STUCK).forEach(lab -> {
            lab.simulators().faults("pioneer").stopReading();
            lab.simulators().faults("hemisson").stopReading();
        });
        team.addListener(new TeamListener() {
            @Override
            public void answered(Answer answer) {
                answers.add(answer);
                answered.countDown();
            }
        });

        team.stopAll();

        answered.await();
        assertThat(answers).extracting(Answer::robot).doesNotHaveDuplicates().hasSize(ROBOTS);
        for (SimulatedLab lab : labs.subList(STUCK, LABS)) {
            assertStands(lab, "hemisson");
        }
    }

    private static void assertStands(SimulatedLab lab, String robot) throws InterruptedException {
        Pose before = lab.truePoses().get(robot);
        lab.time().sleep(0.1);
        assertThat(lab.truePoses().get(robot)).isEqualTo(before);
    }

    private List<MajicBot> connectAll() throws Exception {
        List<Callable<MajicBot>> arrivals = new ArrayList<>();
        for (int count = 0; count < LABS; count++) {
            BotFactory lab = openLab();
            arrivals.add(() -> join(lab, "pioneer"));
            arrivals.add(() -> join(lab, "hemisson"));
        }
        ExecutorService doors = Executors.newFixedThreadPool(ROBOTS);
        try {
            List<MajicBot> bots = new ArrayList<>();
            for (Future<MajicBot> arrival : doors.invokeAll(arrivals)) {
                bots.add(arrival.get());
            }
            return bots;
        } finally {
            doors.shutdown();
        }
    }

    private BotFactory openLab() throws IOException {
        SimulatedLab lab = SimulatedLab.scaled(LabOptions.exactOnFreePorts(), 1);
        labs.add(lab);
        BotFactory factory = new BotFactory(Plugins.in(Path.of("none")).types(), Settings.inMemory());
        factory.useLab(lab);
        return factory;
    }

    private MajicBot join(BotFactory lab, String type) {
        MajicBot bot = lab.create("sim:" + type);
        bot.connect();
        team.add(bot, OptionalInt.empty());
        return bot;
    }
}
