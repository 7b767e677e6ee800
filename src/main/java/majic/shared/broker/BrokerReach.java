package majic.shared.broker;

import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.net.UnknownHostException;
import majic.bot.ConnectFailed;
import majic.link.TcpConnector;

/** Whether a broker's computer and port can be reached, with the same words as for robots. */
final class BrokerReach {
    private static final int TIMEOUT_MS = 2_000;

    private BrokerReach() {}

    /**
     * Looks the computer up and tries its port. Blocks for at most 2 s.
     *
     * @return the computer's address with the name under which its certificate has to be issued
     * @throws ConnectFailed if it cannot be reached; the message has the reason and advice
     */
    static InetAddress find(BrokerAddress address) {
        String host = address.host().replaceAll("[\\[\\]]", "");
        try (Socket socket = new Socket()) {
            new TcpConnector(host, address.port()).connect(socket, TIMEOUT_MS);
            return named(host, socket.getInetAddress());
        } catch (IOException e) {
            throw ConnectFailed.of(e, address + ": " + e.getMessage());
        }
    }

    private static InetAddress named(String host, InetAddress found) throws UnknownHostException {
        return InetAddress.getByAddress(host, found.getAddress());
    }
}
