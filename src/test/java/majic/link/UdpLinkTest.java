package majic.link;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.net.BindException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.Arrays;
import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

/** Datagrams to and from peers on one socket. */
class UdpLinkTest {
    private static final int TIMEOUT_MS = 3000;

    @AutoClose
    private final DatagramSocket peer = new DatagramSocket(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0));

    private final byte[] buffer = new byte[100];

    UdpLinkTest() throws IOException {
        // The socket of the peer may fail to open.
    }

    private static int freePort() throws IOException {
        try (DatagramSocket free = new DatagramSocket(0)) {
            return free.getLocalPort();
        }
    }

    private void send(int port, int... bytes) throws IOException {
        byte[] datagram = new byte[bytes.length];
        for (int index = 0; index < bytes.length; index++) {
            datagram[index] = (byte) bytes[index];
        }
        peer.send(new DatagramPacket(datagram, datagram.length, InetAddress.getLoopbackAddress(), port));
    }

    private byte[] received() throws IOException {
        DatagramPacket packet = new DatagramPacket(buffer, buffer.length);
        peer.receive(packet);
        return Arrays.copyOf(buffer, packet.getLength());
    }

    @Test
    void answersToThePeerThatItsOwnerHasAccepted() throws IOException {
        int port = freePort();
        try (UdpLink link = new UdpLink("", port)) {
            link.open(TIMEOUT_MS);
            link.write(new byte[] {9});
            send(port, 1, 2, 3);
            byte[] own = new byte[10];

            assertThat(link.read(own)).isEqualTo(3);
            assertThat(own).startsWith(1, 2, 3);
            link.addPeer(link.sender());
            link.write(new byte[] {4, 5});

            assertThat(received()).containsExactly(4, 5);
            assertThat(link.traffic().written()).isEqualTo(2);
            assertThat(link.traffic().remote()).isEqualTo("127.0.0.1:" + peer.getLocalPort());
        }
    }

    @Test
    void speaksFirstToAPeerThatIsNamed() throws IOException {
        try (UdpLink link = new UdpLink("127.0.0.1", peer.getLocalPort())) {
            link.open(TIMEOUT_MS);
            link.write(new byte[] {7});

            assertThat(received()).containsExactly(7);
        }
    }

    @Test
    void aPeerThatCannotBeReachedDoesNotKeepTheOthersFromBeingSentTo() throws IOException {
        try (UdpLink link = new UdpLink("", freePort())) {
            link.open(TIMEOUT_MS);
            link.addPeer(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0));
            link.addPeer((InetSocketAddress) peer.getLocalSocketAddress());

            link.write(new byte[] {1});
            link.write(new byte[] {2});

            assertThat(received()).containsExactly(1);
            assertThat(received()).containsExactly(2);
        }
    }

    @Test
    void aPortThatAnotherProgramUsesIsNamed() {
        try (UdpLink link = new UdpLink("", peer.getLocalPort())) {
            assertThatThrownBy(() -> link.open(TIMEOUT_MS))
                    .hasMessageContaining("the UDP port " + peer.getLocalPort() + " of this computer is used")
                    .hasCauseInstanceOf(BindException.class);
        }
    }

    @Test
    void closingWakesTheReader() throws IOException {
        UdpLink link = new UdpLink("", freePort());
        link.open(TIMEOUT_MS);
        CompletableFuture<Integer> read = CompletableFuture.supplyAsync(() -> {
            try {
                return link.read(new byte[10]);
            } catch (IOException e) {
                return -2;
            }
        });

        link.close();

        assertThat(read.join()).isEqualTo(-1);
        assertThatThrownBy(() -> link.write(new byte[] {1})).hasMessage("the connection is closed");
    }
}
