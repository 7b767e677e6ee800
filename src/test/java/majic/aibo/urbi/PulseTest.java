package majic.aibo.urbi;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import majic.TestClock;
import majic.aibo.AiboType;
import majic.aibo.ScriptedDog;
import majic.link.Links;
import majic.time.TimeSource;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(20)
class PulseTest {
    private static final int STOP = 0;

    private final TestClock clock = new TestClock();
    private final Watch watch =
            new Watch(TimeSource.system(), TimeSource.system().signal());
    private ScriptedDog dog;
    private AiboLinks links;
    private Pulse pulse;

    @BeforeEach
    void open() throws IOException {
        dog = ScriptedDog.inRealTime();
        links = new AiboLinks(() -> Links.of(dog.address(), AiboType.PORT, 0), watch, said -> {}, lost -> {});
        links.open();
        Watch stepped = new Watch(clock.time(), clock.time().signal());
        pulse = new Pulse(links.stop(), new Tags(), stepped, new DogClock(stepped));
    }

    @AfterEach
    void close() throws IOException {
        links.abort();
        dog.close();
        clock.close();
    }

    @Test
    void aConnectionThatDiedInSilenceIsFoundOut() throws InterruptedException {
        links.stop().send("x = 1;");
        dog.awaitReceived("x = 1");
        dog.stopReading(STOP);

        assertThat(pulse.beats()).isTrue();
        clock.time().sleep(1);
        assertThat(pulse.beats()).isTrue();
        clock.time().sleep(4.9);
        assertThat(pulse.beats()).isTrue();
        clock.time().sleep(0.2);
        assertThat(pulse.beats()).isFalse();
    }

    @Test
    void oneThatAnswersIsPingedOnceASecond() throws InterruptedException {
        clock.time().sleep(1);
        assertThat(pulse.beats()).isTrue();
        assertThat(pulse.beats()).isTrue();

        dog.awaitReceived("ping");
        assertThat(dog.received("ping")).hasSize(1);
    }
}
