package majic.hemisson.line;

import static org.mockito.ArgumentMatchers.any;
import static org.mockito.Mockito.doThrow;
import static org.mockito.Mockito.mock;
import static org.mockito.Mockito.timeout;
import static org.mockito.Mockito.times;
import static org.mockito.Mockito.verify;

import java.nio.charset.StandardCharsets;
import majic.driver.ReplayLink;
import majic.time.TimeSource;
import majic.time.WaitLimit;
import org.junit.jupiter.api.Test;

/** One connection and its reader thread. */
class HemissonSessionTest {
    @Test
    void anErrorInOneLineDoesNotEndTheLink() {
        byte[] greeting = "HemiOS V1.50\r\n".getBytes(StandardCharsets.ISO_8859_1);
        ConversationListener listener = mock();
        doThrow(new LinkageError("made up")).when(listener).wasReset();

        new HemissonSession(new ReplayLink(greeting, greeting), TimeSource.system(), listener).start();

        verify(listener, timeout(WaitLimit.MS)).broken(any());
        verify(listener, times(2)).wasReset();
    }
}
