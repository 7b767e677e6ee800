package majic.aibo;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.function.BooleanSupplier;
import majic.bot.BotAddress;
import majic.bot.BotException;
import majic.bot.BotListener;
import majic.bot.BotState;
import majic.bot.Guard;
import majic.bot.MajicBot;
import majic.bot.MotionReport;
import majic.bot.MotionStopped;
import majic.bot.Pose;
import majic.bot.Value;
import majic.environment.BotEnvironment;
import majic.environment.Settings;
import majic.simulation.SimulatedLab;
import majic.time.Signal;
import majic.vendor.VendorJar;
import majicsim.LabOptions;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Tests the Aibo's driver by liburbi-java with the simulated dog. The library is the one in the folder that
 * {@code -Dliburbi.home} names; without it a small double of it is compiled, with the same weaknesses.
 */
@Tag("vendor")
class LiburbiInLabTest {
    private static final double LONGEST_S = 30;

    /** How many times as fast as the wall clock; the library waits by the wall clock, so it cannot be stepped. */
    private static final double SPEED = 3;

    @TempDir
    private static Path folder;

    private static String home;

    private SimulatedLab lab;
    private MajicBot dog;
    private double startMm;

    @BeforeAll
    static void findLibrary() throws IOException {
        home = System.getProperty("liburbi.home", "");
        if (home.isEmpty()) {
            VendorJar.compile(Path.of("src/test/resources/liburbi-double"), folder.resolve("liburbi.jar"));
            home = folder.toString();
        }
    }

    @BeforeEach
    void connect() throws IOException {
        lab = SimulatedLab.scaled(LabOptions.exactOnFreePorts(), SPEED);
        Settings settings = Settings.inMemory();
        settings.put("liburbi.home", home);
        BotAddress real = lab.address("aibo").orElseThrow();
        dog = new MajicAibo(new BotAddress("aibo+liburbi", real.rest()), new BotEnvironment(lab.time(), settings));
        dog.connect();
        startMm = pose().xMm();
    }

    @AfterEach
    void close() {
        dog.close();
        lab.close();
    }

    private Pose pose() {
        return lab.truePoses().get("aibo");
    }

    private double walkedMm() {
        return pose().xMm() - startMm;
    }

    @Test
    void theDogWalksTurnsAndTellsItsReadings() {
        assertThat(dog.type().name()).isEqualTo("aibo");
        assertThat(dog.get("battery").number()).isPositive();

        MotionReport walk = dog.move(150);
        double walkedMm = walkedMm();
        dog.turn(30);
        dog.set("headPan", 20);

        assertThat(walk.amount().number()).isCloseTo(150, within(20.0));
        assertThat(walkedMm).isCloseTo(150, within(20.0));
        assertThat(pose().headingDeg()).isCloseTo(30, within(6.0));
        assertThat(dog.get("headPan").number()).isCloseTo(20, within(3.0));
    }

    @Test
    void aPictureAndTheAnswerToARawCommandComeThrough() {
        assertThat(dog.run("urbi", List.of(Value.text("1+1")))).contains("2.0");
        assertThat(dog.run("urbi", List.of(Value.text("camera.val")))).contains("jpeg 208 160");
    }

    @Test
    void aStopEndsAWalkFromAnyThreadAndItStandsThen() throws Exception {
        CompletableFuture<MotionReport> walk = CompletableFuture.supplyAsync(() -> dog.move(2000));
        await(() -> walkedMm() > 50);

        dog.stop();

        assertThatThrownBy(walk::get).isInstanceOf(ExecutionException.class).hasCauseInstanceOf(MotionStopped.class);
        lab.time().sleep(1);
        double stoppedMm = walkedMm();
        lab.time().sleep(1);
        assertThat(stoppedMm).isLessThan(1500);
        assertThat(walkedMm()).isEqualTo(stoppedMm);
    }

    @Test
    void aDriveEndsWithItsTime() throws InterruptedException {
        dog.move(30);
        double beforeMm = walkedMm();

        dog.drive(100, 0, 2, Guard.NEVER);
        lab.time().sleep(1.5);
        double stoppedMm = walkedMm();
        lab.time().sleep(1);

        assertThat(stoppedMm - beforeMm).isGreaterThan(50);
        assertThat(walkedMm()).isEqualTo(stoppedMm);
    }

    @Test
    void aServerThatClosesIsNoticedThoughTheLibraryDoesNot() throws InterruptedException {
        lab.simulators().faults("aibo").cut();

        await(() -> !dog.isConnected());

        assertThat(dog.lostReason()).isPresent();
        assertThatThrownBy(() -> dog.move(100)).isInstanceOf(BotException.class);
    }

    @Test
    void afterALossTheSameDogConnectsAgain() throws InterruptedException {
        lab.simulators().faults("aibo").cut();
        await(() -> !dog.isConnected());
        lab.simulators().faults("aibo").none();

        dog.connect();

        assertThat(dog.move(60).amount().number()).isCloseTo(60, within(20.0));
    }

    /** Tests a condition again at each reading of the dog and each change of its connection. */
    private void await(BooleanSupplier condition) throws InterruptedException {
        Signal changes = lab.time().signal();
        dog.addListener(new BotListener() {
            @Override
            public void stateChanged(MajicBot bot, BotState state) {
                changes.raise();
            }

            @Override
            public void connectionChanged(MajicBot bot, MajicBot.Connection connection) {
                changes.raise();
            }
        });
        assertThat(changes.await(condition, LONGEST_S)).isTrue();
    }
}
