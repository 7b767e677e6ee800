package liburbi.net;

import java.nio.channels.SocketChannel;
import signatures.SignatureOnly;

/** Signature: the socket of a client, and its reader thread, which runs the callbacks. */
public class SocketClient {
    SocketClient() {
        throw new SignatureOnly();
    }

    public SocketChannel getChannel() {
        throw new SignatureOnly();
    }

    public void setSocketChannel(SocketChannel socket) {
        throw new SignatureOnly();
    }
}
