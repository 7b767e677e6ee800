package majic.pioneer.session;

import static org.mockito.ArgumentMatchers.any;
import static org.mockito.Mockito.mock;
import static org.mockito.Mockito.never;
import static org.mockito.Mockito.verify;
import static org.mockito.Mockito.when;

import majic.bot.LinkLost;
import majic.bot.Pose;
import majic.driver.RobotWait;
import majic.pioneer.arcos.PioneerIdentity;
import majic.pioneer.state.Models;
import majic.time.TimeSource;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

class PioneerSessionTest {
    private final PioneerConnection connection = mock();
    private final PioneerSession.Listener listener = mock();
    private PioneerSession session;

    @BeforeEach
    void create() {
        TimeSource time = TimeSource.system();
        when(connection.line()).thenReturn(mock());
        session = new PioneerSession(
                connection,
                new ConnectWait(new RobotWait(time, time.signal()), () -> false),
                Pose.START,
                Models::of,
                listener);
    }

    /** A second report could end the next attempt to connect, which may have begun already. */
    @Test
    void theEndOfAConnectionIsReportedOnce() {
        session.identified(new PioneerIdentity("", "Pioneer", "p3dx-sh"));
        LinkLost first = new LinkLost("made up");

        session.ended(first);
        session.ended(new LinkLost("made up, too"));

        verify(listener).lost(session, first);
    }

    @Test
    void theEndOfAConnectionIsNotReportedBeforeTheRobotIsIdentified() {
        session.ended(new LinkLost("made up"));

        verify(listener, never()).lost(any(), any());
    }
}
