package majic.bot;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.OptionalInt;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** When the system has no thread left, because an act has used them all up for instance, a robot can still be stopped. */
@Timeout(20)
class NoThreadsLeftTest {
    private final Exhaustible time = new Exhaustible();
    private final Team team = new Team(time);

    @AfterEach
    void close() {
        time.exhausted = false;
        team.close();
    }

    /** The system's clock, in a system that may have no threads to give. */
    private static final class Exhaustible implements TimeSource {
        private volatile boolean exhausted;

        @Override
        public long nanos() {
            return TimeSource.system().nanos();
        }

        @Override
        public Signal signal() {
            return TimeSource.system().signal();
        }

        @Override
        public Thread thread(String name, Runnable body) {
            return exhausted ? new Refused() : TimeSource.system().thread(name, body);
        }

        @Override
        public Membership join() {
            return TimeSource.system().join();
        }
    }

    /** What becomes of a thread then. */
    private static final class Refused extends Thread {
        @Override
        public synchronized void start() {
            throw new OutOfMemoryError("unable to create native thread");
        }
    }

    @Test
    void everyRobotIsStopped() {
        FakeBot first = join();
        FakeBot second = join();
        time.exhausted = true;

        team.stopAll();

        assertThat(first.sent()).containsExactly("halt");
        assertThat(second.sent()).containsExactly("halt");
    }

    private FakeBot join() {
        FakeBot bot = FakeBot.on(time);
        bot.connect();
        team.add(bot, OptionalInt.empty());
        return bot;
    }
}
