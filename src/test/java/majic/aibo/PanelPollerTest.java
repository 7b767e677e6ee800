package majic.aibo;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Queue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.CountDownLatch;
import majic.aibo.panel.PanelPoller;
import majic.aibo.urbi.UrbiValue;
import majic.bot.BotListener;
import majic.bot.BotState;
import majic.bot.MajicBot;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

class PanelPollerTest implements PanelPoller.PictureReceiver {
    private static final String ASKED = "camera.val";
    private static final String PICTURE = "BIN 12 YCbCr 2 2\nabcdefghijkl";

    private final Queue<UrbiValue> seen = new ConcurrentLinkedQueue<>();
    private final Queue<String> missed = new ConcurrentLinkedQueue<>();

    @AutoClose
    private final DrivenAibo driven = DrivenAibo.lying();

    private final ScriptedDog dog = driven.dog;
    private final MajicAibo aibo = driven.aibo;
    private PanelPoller poller;

    @BeforeEach
    void createPoller() {
        dog.set(ASKED, PICTURE);
        dog.set("ledF3.val", "0.250000");
        poller = aibo.poller(this);
    }

    @AfterEach
    void stopPolling() {
        poller.look(false);
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
    void nothingIsPolledBeforeThePanelIsShown() {
        aibo.connect();
        awaitReadings();

        assertThat(dog.received(ASKED)).isEmpty();
        assertThat(dog.received()).noneMatch(command -> command.contains("ledF1"));
    }

    @Test
    void picturesAndLedsArePolledWhileThePanelIsShown() {
        aibo.connect();
        poller.look(true);

        next(seen);
        assertThat(next(seen))
                .isInstanceOfSatisfying(
                        UrbiValue.Binary.class,
                        picture -> assertThat(picture.bytes()).hasSize(12));
        awaitReadings();
        assertThat(aibo.dog().leds().amount("ledF3")).contains(0.25);
    }

    @Test
    void nothingIsPolledOnceThePanelIsHidden() {
        aibo.connect();
        poller.look(true);
        next(seen);
        poller.look(false);
        dog.awaitReceived("stop " + lampsTag());
        int asked = dog.received(ASKED).size();
        awaitReadings();

        assertThat(dog.received(ASKED)).hasSize(asked);
    }

    @Test
    void onASlowLinkNoPictureIsRequestedWhileTheDogMoves() {
        dog.set("robot.MyguessPosition()", "\"stand\"");
        dog.set("legLF1.load", "1.000000");
        aibo.connect();
        dog.slownessMs = 600;
        CompletableFuture<Void> walk = driven.aside(() -> aibo.move(500));
        dog.clock().until(() -> aibo.state().moving());
        poller.look(true);

        assertThat(next(missed)).isEqualTo("no pictures while it moves: the link takes 0.6 s for one");
        int asked = dog.received(ASKED).size();
        awaitReadings();
        assertThat(dog.received(ASKED)).hasSize(asked);
        driven.join(walk);
        seen.clear();
        assertThat(next(seen)).isInstanceOf(UrbiValue.Binary.class);
    }

    @Test
    void noSecondPictureIsRequestedWhileOneIsUnderWay() {
        dog.silentAbout = ASKED;
        aibo.connect();
        poller.look(true);
        dog.awaitReceived(ASKED);
        poller.look(false);
        poller.look(true);

        assertThat(next(missed)).isEqualTo("no picture came within 4 s");
        assertThat(dog.received(ASKED)).hasSize(1);
    }

    @Test
    void aLostDogIsReportedAsNotConnectedAndItsPicturesReturnAfterReconnecting() {
        aibo.connect();
        poller.look(true);
        next(seen);
        dog.hangUp();

        assertThat(next(missed)).isEqualTo("not connected");
        seen.clear();
        aibo.connect();
        assertThat(next(seen)).isInstanceOf(UrbiValue.Binary.class);
    }

    @Test
    void anErrorMessageOfTheDogIsReported() {
        dog.set(ASKED, "!!! Unknown identifier: camera.val");
        aibo.connect();
        poller.look(true);

        assertThat(next(missed)).isEqualTo("the dog gives no picture: Unknown identifier: camera.val");
    }

    @Test
    void aLaterServerIsPolledAsWell() {
        dog.speaks15 = true;
        aibo.connect();
        poller.look(true);

        assertThat(next(seen)).isInstanceOf(UrbiValue.Binary.class);
    }

    private <T> T next(Queue<T> heard) {
        dog.clock().until(() -> !heard.isEmpty());
        return heard.remove();
    }

    private String lampsTag() {
        return dog.received().stream()
                .filter(command -> command.contains("ledF1.val") && command.contains("every"))
                .map(command -> command.substring(0, command.indexOf(':')))
                .findFirst()
                .orElseThrow();
    }

    /** Waits as long as a picture would have taken, many times over. */
    private void awaitReadings() {
        CountDownLatch sets = new CountDownLatch(15);
        aibo.addListener(new BotListener() {
            @Override
            public void stateChanged(MajicBot bot, BotState state) {
                sets.countDown();
            }
        });
        dog.clock().until(() -> sets.getCount() == 0);
    }
}
