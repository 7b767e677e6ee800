package liburbi;

import java.io.IOException;
import java.nio.ByteBuffer;
import liburbi.call.UCallbackListener;
import liburbi.call.UCallbackSupport;
import liburbi.call.URBIEvent;
import liburbi.net.SocketClient;

/** The signature's class with a small client behind it, which has the weaknesses that are known of the real one. */
public class UClient {
    public static final int URBI_PORT = 54000;
    public static final int URBI_BUFLEN = 240000;

    protected String host;
    protected int port;
    protected int buflen;
    protected UCallbackSupport callbackSupport;
    protected SocketClient channel;

    public UClient(String host, int port, int buflen) {
        this.host = host;
        this.port = port;
        this.buflen = buflen;
        callbackSupport = new UCallbackSupport();
        channel = new SocketClient(this);
        connect();
        channel.start();
    }

    public void connect() {
        throw new UnsupportedOperationException("this double is connected by its user");
    }

    public void disconnect() {
        channel.disconnect();
    }

    /** Does not return before all is written, however long the peer takes nothing. */
    public final synchronized int effectiveSend(byte[] bytes, int count) throws IOException {
        ByteBuffer left = ByteBuffer.wrap(bytes, 0, count);
        while (left.hasRemaining()) {
            channel.getChannel().write(left);
        }
        return count;
    }

    public final void call(URBIEvent event) {
        callbackSupport.notifyUCallbackListener(event);
    }

    public void setCallback(UCallbackListener listener, String tag) {
        callbackSupport.addUCallbackListener(listener, tag);
    }

    public void deleteCallback(String tag) {
        callbackSupport.removeUCallbackListener(tag);
    }
}
