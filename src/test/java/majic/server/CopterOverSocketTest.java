package majic.server;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.file.Path;
import majic.bot.MajicBot;
import majic.inlab.LabRig;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A client of {@code --listen} flies a copter of the stepped lab. */
class CopterOverSocketTest {
    @Test
    void aClientArmsItTakesOffAndStopsIt(@TempDir Path folder) throws Exception {
        try (LabRig rig = LabRig.exactWithMavlink("copter+ready");
                LineServer server = LineServer.open(
                        new InetSocketAddress(InetAddress.getLoopbackAddress(), 0),
                        rig.session(),
                        port -> ListenToken.create(folder, port))) {
            server.ready();
            MajicBot copter = rig.add("mavlink");
            rig.lab().time().sleep(2);
            try (TestClient client = TestClient.admitted(server)) {
                client.say("1 set fence 5000 500 5000", "1 arm", "1 takeoff 2000");
                rig.await(() -> copter.heightMm().orElse(0) > 1900);
                rig.lab().time().sleep(3);
                assertThat(client.await("1 arm")).isEqualTo("1 arm: armed");
                assertThat(client.await("takeoff")).matches("1 takeoff 2000: \\d+ mm above home");

                client.say("1 get altitude");
                assertThat(client.await("altitude")).matches("1 altitude = \\d+ mm");

                client.say("1 move 3000");
                rig.await(() -> copter.state().moving());
                client.say("1 stop");
                rig.await(() -> copter.get("mode").toString().equals("BRAKE"));
                rig.lab().time().sleep(3);
                assertThat(client.await("1 stop")).isEqualTo("1 stop: done");
                assertThat(copter.state().moving()).isFalse();
            }
        }
    }
}
