package liburbi;

import java.io.IOException;
import liburbi.call.UCallbackListener;
import liburbi.call.UCallbackSupport;
import liburbi.net.SocketClient;
import signatures.SignatureOnly;

/** Signature: a connection to an URBI server, made and opened by its constructor, which calls {@link #connect}. */
public class UClient {
    public static final int URBI_PORT = 54000;
    public static final int URBI_BUFLEN = 240000;

    protected String host;
    protected int port;
    protected int buflen;
    protected UCallbackSupport callbackSupport;
    protected SocketClient channel;

    public UClient(String host, int port, int buflen) {
        throw new SignatureOnly();
    }

    public void connect() {
        throw new SignatureOnly();
    }

    public void disconnect() {
        throw new SignatureOnly();
    }

    public final synchronized int effectiveSend(byte[] bytes, int count) throws IOException {
        throw new SignatureOnly();
    }

    public void setCallback(UCallbackListener listener, String tag) {
        throw new SignatureOnly();
    }

    public void deleteCallback(String tag) {
        throw new SignatureOnly();
    }
}
