package majic.link;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.net.InetSocketAddress;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class ServerAddressTest {
    private static final int DEFAULT_PORT = 8101;

    @ParameterizedTest
    @CsvSource({
        "//10.0.0.5, 10.0.0.5, 8101",
        "//robot-2.example:65535, robot-2.example, 65535",
        "tcp://lab_pc:1, lab_pc, 1",
        "//[::1], [::1], 8101",
        "//[fe80::1%eth0]:4001, [fe80::1%eth0], 4001"
    })
    void hostAndPortAreRead(String address, String host, int port) {
        InetSocketAddress server = Links.server(address, DEFAULT_PORT);

        assertThat(server.getHostString()).isEqualTo(host);
        assertThat(server.getPort()).isEqualTo(port);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "//",
                "//10.0.0.5:0",
                "//10.0.0.5:65536",
                "//10.0.0.5:port",
                "//10.0.0.5:",
                "//10.0.0.5:8101/path",
                "//10.0.0.5?baud=9600",
                "//name:password@10.0.0.5",
                "//two words",
                "//fe80::1",
                "//[::1",
                "//[]",
                "//[robot]"
            })
    void whatCannotBeAServerIsRefusedWithAnAddressThatCan(String address) {
        assertThatThrownBy(() -> Links.server(address, DEFAULT_PORT))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage(
                        address + ": not an address; it looks like //192.168.1.20:8101 with a port from 1 to 65535");
    }
}
