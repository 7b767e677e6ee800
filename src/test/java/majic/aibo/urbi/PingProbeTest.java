package majic.aibo.urbi;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import majic.aibo.AiboType;
import majic.aibo.ScriptedDog;
import majic.driver.RobotWait;
import majic.drivertest.TestClock;
import majic.link.Links;
import majic.time.TimeSource;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

class PingProbeTest {
    private static final int STOP = 0;

    private final TestClock clock = new TestClock();
    private final RobotWait waiting =
            new RobotWait(TimeSource.system(), TimeSource.system().signal());
    private ScriptedDog dog;
    private AiboConnections connections;
    private PingProbe probe;

    @BeforeEach
    void open() throws IOException {
        dog = ScriptedDog.inRealTime();
        connections = new AiboConnections(
                () -> new LinkTransport(Links.of(dog.address(), AiboType.PORT, 0), waiting.time()),
                waiting,
                said -> {},
                lost -> {});
        connections.open();
        RobotWait stepped = new RobotWait(clock.time(), clock.time().signal());
        probe = new PingProbe(connections.stop(), new Tags(), stepped, new DogClock(stepped.time()));
    }

    @AfterEach
    void close() throws IOException {
        connections.abort();
        dog.close();
        clock.close();
    }

    @Test
    void aConnectionThatDiedInSilenceIsFoundOut() throws InterruptedException {
        connections.stop().send("x = 1;");
        dog.awaitReceived("x = 1");
        dog.stopReading(STOP);

        assertThat(probe.check()).isTrue();
        clock.time().sleep(1);
        assertThat(probe.check()).isTrue();
        clock.time().sleep(4.9);
        assertThat(probe.check()).isTrue();
        clock.time().sleep(0.2);
        assertThat(probe.check()).isFalse();
    }

    @Test
    void oneThatAnswersIsPingedOnceASecond() throws InterruptedException {
        clock.time().sleep(1);
        assertThat(probe.check()).isTrue();
        assertThat(probe.check()).isTrue();

        dog.awaitReceived("ping");
        assertThat(dog.received("ping")).hasSize(1);
    }
}
