package majic.pioneer.aria;

import static org.assertj.core.api.Assertions.assertThat;
import static org.mockito.Mockito.mock;
import static org.mockito.Mockito.when;

import com.mobilerobots.Aria.ArRobot;
import com.mobilerobots.Aria.ArTime;
import org.junit.jupiter.api.Test;

class SipDetectorTest {
    private final ArRobot robot = mock();
    private final ArTime last = mock();
    private final SipDetector detector = new SipDetector(robot);

    private boolean isNew(long nowMs, int ageMs) {
        when(robot.getLastOdometryTime()).thenReturn(last);
        when(last.mSecSince()).thenReturn(ageMs);
        return detector.isNew(nowMs * 1_000_000);
    }

    @Test
    void theTimeAtWhichAriaBeganToConnectIsNoSip() {
        assertThat(isNew(1000, 400)).isFalse();
        assertThat(isNew(1010, 410)).isFalse();
        assertThat(isNew(1020, 5)).isTrue();
    }

    @Test
    void everySipIsCountedOnceThoughItsTimeIsInexact() {
        isNew(1000, 400);
        assertThat(isNew(1020, 5)).isTrue();
        assertThat(isNew(1030, 16)).isFalse();
        assertThat(isNew(1040, 24)).isFalse();
        assertThat(isNew(1116, 1)).isTrue();
    }

    @Test
    void anAriaWithoutTimesIsCountedByItsCyclesWhileSipsCome() {
        when(robot.getLastOdometryTime()).thenThrow(new NoSuchMethodError("made up"));
        when(robot.getCounter()).thenReturn(1L, 1L, 2L, 3L);
        when(robot.getMotorPacCount()).thenReturn(10, 10, 0);

        assertThat(detector.isNew(0)).isTrue();
        assertThat(detector.isNew(0)).isFalse();
        assertThat(detector.isNew(0)).isTrue();
        assertThat(detector.isNew(0)).isFalse();
    }
}
