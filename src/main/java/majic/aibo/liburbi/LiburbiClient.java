package majic.aibo.liburbi;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.channels.SocketChannel;
import java.util.function.Consumer;
import liburbi.UClient;
import liburbi.call.UCallbackSupport;
import liburbi.call.URBIEvent;

/**
 * Puts the library's client on a socket that is connected already, with one listener for all messages. The library
 * itself would connect without a time limit, print failures instead of reporting them, never close its socket, and
 * print the messages that come before a listener is set.
 */
final class LiburbiClient {
    private LiburbiClient() {}

    /**
     * Creates a client, which reads from now on.
     *
     * @param socket connected and not blocking
     * @param listener receives every message on the library's thread; must not throw, and must not wait
     */
    static UClient on(SocketChannel socket, Consumer<URBIEvent> listener) {
        UCallbackSupport listeners = new UCallbackSupport() {
            @Override
            public void notifyUCallbackListener(URBIEvent event) {
                listener.accept(event);
            }
        };
        return new UClient("", UClient.URBI_PORT, UClient.URBI_BUFLEN) {
            /** Called by the library's constructor, before it starts its thread. */
            @Override
            public void connect() {
                try {
                    channel.getChannel().close();
                } catch (IOException e) {
                    throw new UncheckedIOException(e);
                }
                channel.setSocketChannel(socket);
                callbackSupport = listeners;
            }
        };
    }
}
