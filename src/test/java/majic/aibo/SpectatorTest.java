package majic.aibo;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import majic.bot.BotEnvironment;
import majic.bot.BotListener;
import majic.bot.BotState;
import majic.bot.MajicBot;
import majic.bot.Settings;
import majic.bot.TimeSource;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(40)
class SpectatorTest implements Spectator.Audience {
    private static final String ASKED = "camera.val";
    private static final String PICTURE = "BIN 12 YCbCr 2 2\nabcdefghijkl";

    private final BlockingQueue<UrbiValue> seen = new LinkedBlockingQueue<>();
    private final BlockingQueue<String> missed = new LinkedBlockingQueue<>();
    private ScriptedDog dog;
    private MajicAibo aibo;
    private Spectator spectator;

    @BeforeEach
    void connect() throws IOException {
        dog = new ScriptedDog();
        dog.set(ASKED, PICTURE);
        dog.set("ledF3.val", "0.250000");
        aibo = new MajicAibo(dog.address(), new BotEnvironment(TimeSource.system(), Settings.inMemory()));
        spectator = aibo.spectator(this);
    }

    @AfterEach
    void close() throws IOException {
        spectator.look(false);
        aibo.close();
        dog.close();
    }

    @Override
    public void see(UrbiValue picture, double perSecond) {
        seen.add(picture);
    }

    @Override
    public void miss(String why) {
        missed.add(why);
    }

    @Test
    void nothingIsAskedForBeforeSomebodyLooks() throws InterruptedException {
        aibo.connect();
        awaitReadings();

        assertThat(dog.received(ASKED)).isEmpty();
        assertThat(dog.received()).noneMatch(command -> command.contains("ledF1"));
    }

    @Test
    void picturesAndLampsComeWhileSomebodyLooks() throws InterruptedException {
        aibo.connect();
        spectator.look(true);

        seen.take();
        assertThat(seen.take())
                .isInstanceOfSatisfying(
                        UrbiValue.Binary.class,
                        picture -> assertThat(picture.bytes()).hasSize(12));
        awaitReadings();
        assertThat(aibo.dog().lamps().amount("ledF3")).contains(0.25);
    }

    @Test
    void onceNobodyLooksNothingMoreIsAskedFor() throws InterruptedException {
        aibo.connect();
        spectator.look(true);
        seen.take();
        spectator.look(false);
        dog.awaitReceived("stop " + lampsTag());
        int asked = dog.received(ASKED).size();
        awaitReadings();

        assertThat(dog.received(ASKED)).hasSize(asked);
    }

    @Test
    void noSecondPictureIsAskedForWhileOneIsUnderWay() throws InterruptedException {
        dog.silentAbout = ASKED;
        aibo.connect();
        spectator.look(true);
        dog.awaitReceived(ASKED);
        spectator.look(false);
        spectator.look(true);

        assertThat(missed.take()).isEqualTo("no picture came within 4 s");
        assertThat(dog.received(ASKED)).hasSize(1);
    }

    @Test
    void aLostDogIsSaidToBeNotConnectedAndIsSeenAgainOnceItIsBack() throws InterruptedException {
        aibo.connect();
        spectator.look(true);
        seen.take();
        dog.hangUp();

        assertThat(missed.take()).isEqualTo("not connected");
        seen.clear();
        aibo.connect();
        assertThat(seen.take()).isInstanceOf(UrbiValue.Binary.class);
    }

    @Test
    void whatTheDogComplainsOfIsPassedOn() throws InterruptedException {
        dog.set(ASKED, "!!! Unknown identifier: camera.val");
        aibo.connect();
        spectator.look(true);

        assertThat(missed.take()).isEqualTo("the dog gives no picture: Unknown identifier: camera.val");
    }

    @Test
    void aLaterServerIsLookedAtAsWell() throws InterruptedException {
        dog.speaks15 = true;
        aibo.connect();
        spectator.look(true);

        assertThat(seen.take()).isInstanceOf(UrbiValue.Binary.class);
    }

    private String lampsTag() {
        return dog.received().stream()
                .filter(command -> command.contains("ledF1.val") && command.contains("every"))
                .map(command -> command.substring(0, command.indexOf(':')))
                .findFirst()
                .orElseThrow();
    }

    /** Waits as long as a picture would have taken, many times over. */
    private void awaitReadings() throws InterruptedException {
        CountDownLatch sets = new CountDownLatch(15);
        aibo.addListener(new BotListener() {
            @Override
            public void stateChanged(MajicBot bot, BotState state) {
                sets.countDown();
            }
        });
        sets.await();
    }
}
