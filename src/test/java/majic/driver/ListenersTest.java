package majic.driver;

import static org.mockito.ArgumentMatchers.any;
import static org.mockito.ArgumentMatchers.eq;
import static org.mockito.Mockito.doThrow;
import static org.mockito.Mockito.mock;
import static org.mockito.Mockito.never;
import static org.mockito.Mockito.verify;
import static org.mockito.Mockito.verifyNoInteractions;

import majic.bot.BotListener;
import majic.bot.FakeBot;
import majic.bot.MajicBot;
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
    }

    @Test
    void aListenerReceivesNoEventFromBeforeItWasAdded() {
        WaitPolicy.without(() -> {
            listeners.connectionChanged(MajicBot.Connection.CONNECTED);
            listeners.deliver();
        });
        listeners.add(first);
        listeners.deliver();

        verifyNoInteractions(first);
    }
}
