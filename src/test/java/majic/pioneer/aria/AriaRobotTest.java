package majic.pioneer.aria;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.mockito.Mockito.inOrder;
import static org.mockito.Mockito.mock;
import static org.mockito.Mockito.never;
import static org.mockito.Mockito.verify;
import static org.mockito.Mockito.when;

import com.mobilerobots.Aria.ArDeviceConnection;
import com.mobilerobots.Aria.ArRobot;
import com.mobilerobots.Aria.ArTime;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import majic.bot.LinkLost;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.mockito.InOrder;

class AriaRobotTest {
    private final ArRobot aria = mock();
    private final AriaRobot robot = new AriaRobot(aria, new AriaLaser(aria));

    @Test
    void aCallIsMadeBetweenLockAndUnlock() {
        robot.locked(ArRobot::getFlags);

        InOrder order = inOrder(aria);
        order.verify(aria).tryLock();
        order.verify(aria).getFlags();
        order.verify(aria).unlock();
    }

    @Test
    void theLockIsReleasedAfterAnError() {
        when(aria.getFlags()).thenThrow(new UnsatisfiedLinkError("made up"));

        assertThatThrownBy(() -> robot.locked(ArRobot::getFlags)).isInstanceOf(UnsatisfiedLinkError.class);

        verify(aria).unlock();
    }

    @Test
    void aLockThatIsBusyIsTriedAgain() {
        when(aria.tryLock()).thenReturn(3, 3, 0);

        robot.locked(ArRobot::getFlags);

        verify(aria).getFlags();
    }

    @Test
    void anAriaThatKeepsTheLockIsALostConnection() {
        when(aria.tryLock()).thenReturn(3);

        assertThatThrownBy(() -> robot.locked(ArRobot::getFlags))
                .isInstanceOf(LinkLost.class)
                .hasMessage("connection lost: ARIA has not reacted for 1 s");
        verify(aria, never()).getFlags();
        verify(aria, never()).unlock();
    }

    @Test
    void aRobotIsReservedForOneConnectionUntilThatHasEnded() {
        ArDeviceConnection device = mock();
        when(aria.blockingConnect()).thenReturn(true);
        assertThat(robot.reserve()).isTrue();
        assertThat(robot.reserve()).isFalse();
        robot.connect(new AriaDevice("tcp:robot:8101", () -> new AriaDevice.Opened(device, 0)));

        robot.disconnect();

        InOrder order = inOrder(aria, device);
        order.verify(aria).setDeviceConnection(device);
        order.verify(aria).blockingConnect();
        order.verify(aria).runAsync(true);
        order.verify(aria).stopRunning(true);
        order.verify(device).close();
        assertThat(robot.reserve()).isTrue();
    }

    @Test
    void theMethodsWithoutWhichNoRobotCanBeDrivenAreLookedFor() throws NoSuchMethodException {
        AriaMethods.check(ArRobot.class);

        assertThatThrownBy(() -> AriaMethods.check(ArTime.class))
                .isInstanceOf(NoSuchMethodException.class)
                .hasMessageContaining("com.mobilerobots.Aria.ArTime.");
    }

    @Test
    void ariasFolderIsTheOneWithItsParameters(@TempDir Path folder) throws IOException {
        Files.createDirectories(folder.resolve("params"));
        Path jar = Files.createDirectories(folder.resolve("java")).resolve("Aria.jar");

        assertThat(AriaConnections.home(jar, jar.getParent())).isEqualTo(folder);
        assertThat(AriaConnections.home(null, folder)).isEqualTo(folder);
    }
}
