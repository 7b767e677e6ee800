package majic.pioneer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static org.assertj.core.api.Assumptions.assumeThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import majic.bot.BotAddress;
import majic.bot.BotException;
import majic.bot.BotListener;
import majic.bot.BotState;
import majic.bot.MajicBot;
import majic.bot.MotionStopped;
import majic.environment.BotEnvironment;
import majic.environment.Settings;
import majic.simulation.SimulatedLab;
import majic.vendor.VendorJar;
import majic.vendor.VendorLibraries;
import majic.vendor.VendorLibrary;
import majicsim.LabOptions;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Tests the Pioneer's driver through ARIA, loaded as users have it, at the pace of the wall clock. The library is the
 * one in the folder that {@code -Daria.home} names, with the lab's Pioneer; without it a small double of it is
 * compiled, which moves a robot of its own. Its native library is any one that Java has.
 */
@Tag("vendor")
class AriaInLabTest {
    @TempDir
    private static Path folder;

    private static String home;

    private SimulatedLab lab;
    private MajicBot bot;

    @BeforeAll
    static void findLibrary() throws IOException {
        home = System.getProperty("aria.home", "");
        if (home.isEmpty()) {
            Path any = Path.of(System.getProperty("java.home"), "lib", System.mapLibraryName("prefs"));
            assumeThat(any).exists();
            VendorJar.compile(Path.of("src/test/resources/aria-double"), folder.resolve("java/Aria.jar"));
            Files.createDirectories(folder.resolve("params"));
            Files.copy(any, folder.resolve(System.mapLibraryName("AriaJava")));
            home = folder.toString();
        }
    }

    @AfterAll
    static void forgetLibrary() {
        VendorLibraries.forget(VendorLibrary.ARIA);
    }

    @BeforeEach
    void connect() throws IOException {
        lab = SimulatedLab.scaled(LabOptions.exactOnFreePorts(), 1);
        bot = create(lab.address("pioneer").orElseThrow().rest());
        bot.connect();
    }

    private MajicBot create(String address) {
        Settings settings = Settings.inMemory();
        settings.put("aria.home", home);
        return new PioneerType()
                .create(new BotAddress("pioneer+aria", address), new BotEnvironment(lab.time(), settings));
    }

    @AfterEach
    void close() {
        bot.close();
        lab.close();
    }

    @Test
    void motionsEndWithinTenMillimetresAndADegree() {
        bot.move(300);
        assertThat(bot.get("x").number()).isCloseTo(300, within(10.0));

        bot.turn(-90);
        assertThat(bot.get("heading").number()).isCloseTo(-90, within(1.0));
    }

    @Test
    void aStopEndsAMotion() throws InterruptedException {
        CountDownLatch moving = new CountDownLatch(1);
        bot.addListener(new BotListener() {
            @Override
            public void stateChanged(MajicBot from, BotState state) {
                if (state.pose().xMm() > 50) {
                    moving.countDown();
                }
            }
        });
        CompletableFuture<Void> motion = CompletableFuture.runAsync(() -> bot.move(2000));
        moving.await();

        bot.stop();

        assertThatThrownBy(motion::join).hasCauseInstanceOf(MotionStopped.class);
        assertThat(bot.get("moving").isYes()).isFalse();
    }

    @Test
    void theRobotIsConnectedAgainAfterClosing() {
        assertThat(bot.get("model").toString()).startsWith("p3dx");
        bot.close();

        bot = create(lab.address("pioneer").orElseThrow().rest());
        bot.connect();

        assertThat(bot.get("voltage").number()).isBetween(8.0, 16.0);
    }

    @Test
    void aSerialPortThatDoesNotExistIsReported() {
        MajicBot other = create("/dev/none");

        assertThatThrownBy(other::connect)
                .isInstanceOf(BotException.class)
                .hasMessageStartingWith("ARIA cannot open serial:/dev/none");
    }
}
