package majic.driver;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.mockito.ArgumentMatchers.any;
import static org.mockito.ArgumentMatchers.eq;
import static org.mockito.Mockito.doThrow;
import static org.mockito.Mockito.mock;
import static org.mockito.Mockito.never;
import static org.mockito.Mockito.verify;
import static org.mockito.Mockito.verifyNoInteractions;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import majic.bot.Beam;
import majic.bot.BotListener;
import majic.bot.FakeBot;
import majic.bot.MajicBot;
import majic.bot.MajicBot.Connection;
import majic.bot.Pose;
import majic.bot.RangeScan;
import majic.bot.RangeSensor;
import majic.drivertest.TestClock;
import majic.time.TimeSource;
import majic.time.WaitPolicy;
import org.junit.jupiter.api.Test;

/** Tests which listeners receive the notices of a robot, and when. */
class ListenersTest {
    private final Listeners listeners = new Listeners(FakeBot.on(TimeSource.system()), TimeSource.system());
    private final BotListener first = mock();
    private final BotListener second = mock();
    private final EventOnlyListener eventOnly = mock();

    @Test
    void aNoticeBeforeThereIsAListenerIsKeptForTheFirst() {
        listeners.notice("the switches are wrong");
        listeners.add(first);
        listeners.add(second);

        verify(first).notice(any(), eq("the switches are wrong"));
        verifyNoInteractions(second);
    }

    @Test
    void laterNoticesReachAllListeners() {
        listeners.add(first);
        listeners.add(second);
        listeners.notice("it stands");

        verify(first).notice(any(), eq("it stands"));
        verify(second).notice(any(), eq("it stands"));
    }

    @Test
    void aListenerThatFailsDoesNotKeepOthersFromBeingCalled() {
        doThrow(new IllegalStateException("a bad listener")).when(first).notice(any(), any());
        listeners.add(first);
        listeners.add(second);
        listeners.notice("it stands");

        verify(second).notice(any(), eq("it stands"));
    }

    @Test
    void newReadingsAreNotQueuedWhileAllListenersIgnoreThem() {
        listeners.add(eventOnly);
        WaitPolicy.without(listeners::stateChanged);
        listeners.add(second);
        listeners.deliver();

        verify(second, never()).stateChanged(any(), any());
    }

    @Test
    void newReadingsReachAListenerBesideOneThatIgnoresThem() {
        listeners.add(second);
        listeners.add(eventOnly);
        listeners.stateChanged();

        verify(second).stateChanged(any(), any());
        verifyNoInteractions(eventOnly);
    }

    private static RangeScan scan(double timeS, float mm) {
        Beam beam = new Beam(Pose.START, 1, 0, 5000, 10);
        return new RangeScan(new RangeSensor("laser", List.of(beam)), timeS, Pose.START, mm);
    }

    @Test
    void scansReachOnlyThoseThatAskForThem() {
        List<RangeScan> received = new CopyOnWriteArrayList<>();
        listeners.add(first);
        listeners.scanned(scan(1, 800));
        listeners.addScanListener(received::add);
        RangeScan asked = scan(2, 900);
        listeners.scanned(asked);

        assertThat(received).containsExactly(asked);
        verifyNoInteractions(first);
    }

    @Test
    void ofScansThatComeFasterThanTheyAreTakenTheNewestIsDelivered() {
        List<RangeScan> received = new CopyOnWriteArrayList<>();
        listeners.addScanListener(received::add);
        RangeScan newest = scan(2, 900);
        WaitPolicy.without(() -> {
            listeners.scanned(scan(1, 800));
            listeners.scanned(newest);
        });
        listeners.deliver();

        assertThat(received).containsExactly(newest);
    }

    @Test
    void aListenerReceivesNoEventFromBeforeItWasAdded() {
        WaitPolicy.without(() -> {
            listeners.connectionChanged(Connection.CONNECTED);
            listeners.deliver();
        });
        listeners.add(first);
        listeners.deliver();

        verifyNoInteractions(first);
    }

    @Test
    void aChangeOfTheConnectionIsDeliveredAlsoByTheListenerThreadBeforeTheCallReturns() throws InterruptedException {
        try (TestClock clock = new TestClock()) {
            SlowListener slow = new SlowListener(clock, 0.2);
            Listeners threaded = busyWith(slow, clock);

            threaded.connectionChanged(Connection.CONNECTED);
            threaded.deliver();

            assertThat(slow.received).containsExactly(Connection.LOST, Connection.CONNECTED);
            threaded.close();
        }
    }

    @Test
    void aListenerThatBlocksDelaysAChangeOfTheConnectionForOneSecond() throws InterruptedException {
        try (TestClock clock = new TestClock()) {
            Listeners threaded = busyWith(new SlowListener(clock, 60), clock);
            long before = clock.time().nanos();

            threaded.connectionChanged(Connection.CONNECTED);
            threaded.deliver();

            assertThat(clock.time().secondsSince(before)).isCloseTo(1, within(0.01));
            threaded.close();
        }
    }

    /** Returns listeners whose thread is delivering a first change to a slow one. */
    private static Listeners busyWith(SlowListener slow, TestClock clock) throws InterruptedException {
        Listeners threaded = new Listeners(FakeBot.on(clock.time()), clock.time());
        threaded.start(clock.time(), "fake");
        threaded.add(slow);
        WaitPolicy.without(() -> {
            threaded.connectionChanged(Connection.LOST);
            threaded.deliver();
        });
        clock.time().sleep(0.1);
        assertThat(slow.received).isEmpty();
        return threaded;
    }

    /** Takes a while for each change of the connection. */
    private record SlowListener(TestClock clock, double seconds, List<Connection> received) implements BotListener {
        SlowListener(TestClock clock, double seconds) {
            this(clock, seconds, new CopyOnWriteArrayList<>());
        }

        @Override
        public void connectionChanged(MajicBot bot, Connection connection) {
            try {
                clock.time().sleep(seconds);
                received.add(connection);
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
            }
        }
    }
}
