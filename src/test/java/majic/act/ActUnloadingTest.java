package majic.act;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.ref.WeakReference;
import java.nio.file.Path;
import majic.act.file.ActFile;
import majic.bot.FakeBot;
import majic.bot.FakeType;
import majic.drivertest.TestClock;
import majic.environment.BotEnvironment;
import majic.environment.Settings;
import majic.time.TimeSource;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests that the classes of an act are unloaded after its end. */
@Tag("jdk")
class ActUnloadingTest {
    private static final String ANYWHERE = Sources.WANDER.replace(".types(\"aibo\").with(\"distanceFront\")", "");

    @TempDir
    Path folder;

    @Test
    void anActThatHasRunGoesWithItsClasses() throws InterruptedException {
        ActFile file = ActFile.of("wander.act", Sources.act(folder, "Wander", ANYWHERE));
        WeakReference<ClassLoader> classes = run(file);
        while (classes.get() != null && !Thread.interrupted()) {
            System.gc();
            Thread.onSpinWait();
        }
        assertThat(classes.get()).isNull();
        assertThat(file.details().name()).isEqualTo("Wander");
    }

    private static WeakReference<ClassLoader> run(ActFile file) throws InterruptedException {
        try (TestClock clock = new TestClock();
                FakeBot robot = dog(clock.time())) {
            robot.connect();
            MajicAct act = file.load(Sources.trusting(file));
            act.start(robot);
            clock.time().sleep(10);
            act.join();
            assertThat(robot.sent()).startsWith("move 600");
            return new WeakReference<>(act.getClass().getClassLoader());
        }
    }

    private static FakeBot dog(TimeSource time) {
        return new FakeBot(new FakeType("aibo"), new BotEnvironment(time, Settings.inMemory()));
    }
}
