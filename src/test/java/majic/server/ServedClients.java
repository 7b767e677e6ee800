package majic.server;

import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.util.ArrayList;
import java.util.List;
import javax.net.SocketFactory;

/** A server for a session with robot 1, and the clients that a test connects to it; closes all of them. */
final class ServedClients implements AutoCloseable {
    final RobotTeam robots = new RobotTeam();
    final LineServer server;
    private final SocketFactory sockets;
    private final List<TestClient> clients = new ArrayList<>();

    /** Opens a server for the session of a team. */
    interface Opening {
        LineServer open(RobotTeam robots) throws IOException;
    }

    ServedClients(SocketFactory sockets, Opening opening) throws IOException {
        this.sockets = sockets;
        server = opening.open(robots);
        server.ready();
    }

    Socket socket() throws IOException {
        return sockets.createSocket(InetAddress.getLoopbackAddress(), server.port());
    }

    /** Connects a client that has sent no token yet. */
    TestClient stranger() throws IOException {
        TestClient client = new TestClient(socket());
        clients.add(client);
        return client;
    }

    /** Connects a client and sends the token. */
    TestClient admitted() throws IOException {
        return stranger().say(server.token().orElseThrow().word());
    }

    @Override
    public void close() throws IOException {
        for (TestClient client : clients) {
            client.close();
        }
        server.close();
        robots.close();
    }
}
