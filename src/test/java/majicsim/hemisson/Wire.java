package majicsim.hemisson;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.FileInputStream;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.Socket;
import java.nio.charset.StandardCharsets;

/** A client's end of the robot's line, over TCP or a pseudo-terminal, in Latin-1 characters. */
record Wire(InputStream in, OutputStream out) implements AutoCloseable {

    static Wire tcp(String address) throws IOException {
        int colon = address.lastIndexOf(':');
        Socket socket = new Socket(address.substring(0, colon), Integer.parseInt(address.substring(colon + 1)));
        socket.setTcpNoDelay(true);
        return new Wire(socket.getInputStream(), socket.getOutputStream());
    }

    static Wire device(String path) throws IOException {
        return new Wire(new FileInputStream(path), new FileOutputStream(path));
    }

    void send(String text) throws IOException {
        out.write(text.getBytes(StandardCharsets.ISO_8859_1));
    }

    /** Reads exactly as many characters as are expected, and compares. */
    void expect(String text) throws IOException {
        StringBuilder read = new StringBuilder();
        for (int c = 0; c >= 0 && read.length() < text.length(); ) {
            c = in.read();
            read.append((char) c);
        }
        assertThat(read.toString()).isEqualTo(text);
    }

    /** Reads until a text has come. */
    void skipTo(String text) throws IOException {
        StringBuilder read = new StringBuilder();
        while (read.indexOf(text) < 0) {
            int c = in.read();
            assertThat(c).isNotNegative();
            read.append((char) c);
        }
    }

    /** Sends a command with its CR, and expects a reply with CR LF. */
    void exchange(String command, String reply) throws IOException {
        send(command + "\r");
        expect(reply + "\r\n");
    }

    @Override
    public void close() throws IOException {
        out.close();
        in.close();
    }
}
