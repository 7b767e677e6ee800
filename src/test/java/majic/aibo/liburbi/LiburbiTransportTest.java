package majic.aibo.liburbi;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.mockito.ArgumentMatchers.any;
import static org.mockito.ArgumentMatchers.anyInt;
import static org.mockito.ArgumentMatchers.argThat;
import static org.mockito.Mockito.doAnswer;
import static org.mockito.Mockito.doThrow;
import static org.mockito.Mockito.inOrder;
import static org.mockito.Mockito.lenient;
import static org.mockito.Mockito.mock;
import static org.mockito.Mockito.never;
import static org.mockito.Mockito.timeout;
import static org.mockito.Mockito.times;
import static org.mockito.Mockito.verify;
import static org.mockito.Mockito.verifyNoInteractions;
import static org.mockito.Mockito.when;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.channels.SocketChannel;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import liburbi.UClient;
import liburbi.call.URBIEvent;
import majic.aibo.urbi.UrbiMessage;
import majic.aibo.urbi.UrbiTransport.Receiver;
import majic.aibo.urbi.UrbiValue;
import majic.link.TcpConnector;
import majic.time.WaitLimit;
import majic.time.WaitPolicy;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.mockito.ArgumentCaptor;
import org.mockito.InOrder;
import org.mockito.Mock;
import org.mockito.junit.jupiter.MockitoExtension;

/** Tests the adapter with doubles of the library's classes, on a real socket. */
@ExtendWith(MockitoExtension.class)
class LiburbiTransportTest {

    @Mock
    private UClient client;

    @Mock
    private Receiver receiver;

    private ServerSocket server;
    private LiburbiTransport transport;
    private volatile Consumer<URBIEvent> listener;
    private volatile SocketChannel socket;

    @BeforeEach
    void listen() throws IOException {
        server = new ServerSocket(0, 1, InetAddress.getLoopbackAddress());
        transport = transport(server.getLocalPort());
    }

    private LiburbiTransport transport(int port) {
        return new LiburbiTransport(new TcpConnector("127.0.0.1", port), (opened, heard) -> {
            socket = opened;
            listener = heard;
            return client;
        });
    }

    @AfterEach
    void close() throws IOException {
        transport.abort();
        server.close();
    }

    private void open() throws IOException {
        transport.open(1000, "aibo motion", receiver);
    }

    @Test
    void theLibraryGetsASocketThatIsConnectedAndDoesNotBlock() throws IOException {
        open();

        assertThat(socket.isConnected()).isTrue();
        assertThat(socket.isBlocking()).isFalse();
        assertThat(socket.socket().getTcpNoDelay()).isTrue();
    }

    @Test
    void aServerThatIsNotThereIsReportedWithoutTheLibrary() throws IOException {
        server.close();

        assertThatThrownBy(this::open).hasMessage("nothing listens at 127.0.0.1 port " + server.getLocalPort());
        assertThat(listener).isNull();
        verifyNoInteractions(client, receiver);
    }

    @Test
    void aLibraryOfAnotherVersionIsReportedAndItsSocketClosed() throws IOException {
        transport = new LiburbiTransport(new TcpConnector("127.0.0.1", server.getLocalPort()), (opened, heard) -> {
            socket = opened;
            throw new NoSuchMethodError("setSocketChannel");
        });

        assertThatThrownBy(this::open)
                .isInstanceOf(IOException.class)
                .hasMessageStartingWith("liburbi-java cannot be used: ")
                .hasMessageContaining("setSocketChannel");
        assertThat(socket.isOpen()).isFalse();
    }

    @Test
    void whatIsClosedBeforeDoesNotOpen() {
        transport.close();

        assertThatThrownBy(this::open).hasMessage("closed while connecting");
        verifyNoInteractions(client);
    }

    @Test
    void aCommandIsWrittenAsItsBytesWhateverTheSystemsCharset() throws IOException {
        open();

        transport.write(bytes("t: \"é\";"));

        verify(client).effectiveSend(bytes("t: \"é\";"), 7);
    }

    @Test
    void eventsBecomeMessagesInTheirOrderOnAThreadThatMustNotWait() throws IOException {
        boolean[] mayWait = {true};
        doAnswer(call -> mayWait[0] = WaitPolicy.isAllowed()).when(receiver).received(any());
        open();

        listener.accept(text(1200, "mj_1", "87.000000"));
        listener.accept(text(1250, "mj_1", "*** end"));
        listener.accept(text(1300, null, "!!! Unknown identifier: x"));

        InOrder order = inOrder(receiver);
        order.verify(receiver, timeout(WaitLimit.MS))
                .received(new UrbiMessage(1200, "mj_1", new UrbiMessage.Result(new UrbiValue.Num(87))));
        order.verify(receiver, timeout(WaitLimit.MS))
                .received(new UrbiMessage(1250, "mj_1", new UrbiMessage.Info("end")));
        order.verify(receiver, timeout(WaitLimit.MS))
                .received(new UrbiMessage(1300, "notag", new UrbiMessage.Failure("Unknown identifier: x")));
        assertThat(mayWait[0]).isFalse();
    }

    @Test
    void aPictureAndASoundKeepTheirHeader() throws IOException {
        open();
        URBIEvent picture = binary("jpeg");
        when(picture.getWidth()).thenReturn(208);
        when(picture.getHeight()).thenReturn(160);
        URBIEvent sound = binary("raw");
        when(sound.getSampleRate()).thenReturn(16000f);
        when(sound.getNbOfChannels()).thenReturn(2);
        when(sound.getNbOfBits()).thenReturn(16);
        when(sound.getSigned()).thenReturn(true);

        listener.accept(picture);
        listener.accept(sound);

        verify(receiver, timeout(WaitLimit.MS)).received(argThat(message -> isBinary(message, "jpeg", "208", "160")));
        verify(receiver, timeout(WaitLimit.MS))
                .received(argThat(message -> isBinary(message, "raw", "2", "16000", "16", "1")));
    }

    private static URBIEvent binary(String type) {
        URBIEvent event = mock();
        when(event.getTag()).thenReturn("b");
        when(event.getBinBuffer()).thenReturn(new byte[] {1, 2, 3});
        when(event.getType()).thenReturn(type);
        return event;
    }

    private static boolean isBinary(UrbiMessage message, String... header) {
        return message.body() instanceof UrbiMessage.Result result
                && result.value() instanceof UrbiValue.Binary binary
                && binary.words().equals(List.of(header))
                && binary.bytes().length == 3;
    }

    @Test
    void aReceiverThatFailsNeitherEndsTheLibrarysThreadNorTheConnection() throws IOException {
        doThrow(new IllegalStateException("made up"))
                .doThrow(new LinkageError("made up"))
                .doNothing()
                .when(receiver)
                .received(any());
        open();

        listener.accept(text(1, "a", "1"));
        listener.accept(text(2, "b", "2"));
        listener.accept(text(3, "c", "3"));

        verify(receiver, timeout(WaitLimit.MS))
                .received(argThat(message -> message.tag().equals("c")));
        verify(receiver, never()).ended(any());
    }

    @Test
    void anEventThatCannotBeReadDoesNotEndTheLibrarysThread() throws IOException {
        open();
        URBIEvent damaged = mock();
        when(damaged.getBinBuffer()).thenThrow(new IllegalStateException("made up"));

        listener.accept(damaged);
        listener.accept(text(2, "b", "2"));

        verify(receiver, timeout(WaitLimit.MS))
                .received(argThat(message -> message.tag().equals("b")));
    }

    @Test
    void aReceiverThatWaitsDoesNotHoldTheLibrarysThread() throws IOException {
        CountDownLatch goOn = new CountDownLatch(1);
        doAnswer(call -> {
                    goOn.await();
                    return null;
                })
                .when(receiver)
                .received(any());
        open();

        URBIEvent reading = text(1, "a", "1");
        for (int count = 0; count < 1000; count++) {
            listener.accept(reading);
        }

        goOn.countDown();
        verify(receiver, timeout(WaitLimit.MS).times(1000)).received(any());
    }

    @Test
    void aWriteThatFailsEndsTheConnectionOnce() throws IOException {
        when(client.effectiveSend(any(), anyInt())).thenThrow(new IOException("Broken pipe"));
        open();

        assertThatThrownBy(() -> transport.write(bytes("x;")))
                .isInstanceOf(IOException.class)
                .hasMessage("the dog closed it");

        verify(receiver, timeout(WaitLimit.MS)).ended(argThat(cause -> "the dog closed it".equals(cause.getMessage())));
        assertThat(socket.isOpen()).isFalse();
        assertThatThrownBy(() -> transport.write(bytes("y;"))).hasMessage("the connection is closed");
    }

    @Test
    void aPeerThatTakesNoMoreDataEndsTheConnectionThoughTheLibraryNeverReturns() throws IOException {
        CountDownLatch closed = new CountDownLatch(1);
        when(client.effectiveSend(any(), anyInt())).thenAnswer(call -> {
            closed.await();
            return 0;
        });
        open();

        assertThatThrownBy(() -> transport.write(bytes("x;"))).hasMessage("the dog takes no more data");

        assertThat(socket.isOpen()).isFalse();
        closed.countDown();
    }

    @Test
    void anInterruptedThreadWritesAllTheSameAndStaysInterrupted() throws IOException {
        open();
        Thread.currentThread().interrupt();
        try {
            transport.write(bytes("stop walk;"));
        } finally {
            assertThat(Thread.interrupted()).isTrue();
        }

        verify(client).effectiveSend(bytes("stop walk;"), 10);
        assertThat(socket.isOpen()).isTrue();
    }

    @Test
    void aQuietConnectionIsProbedWithAnEmptyCommandAndItsEndNoticed() throws IOException {
        when(client.effectiveSend(any(), anyInt())).thenReturn(1).thenThrow(new IOException("Broken pipe"));
        open();

        verify(receiver, timeout(WaitLimit.MS)).ended(argThat(cause -> "the dog closed it".equals(cause.getMessage())));
        verify(client, times(2)).effectiveSend(bytes(";"), 1);
    }

    @Test
    void aStreamWhoseEndTheLibraryDoesNotReadIsProbedMoreOften() throws Exception {
        CountDownLatch probes = new CountDownLatch(30);
        when(client.effectiveSend(any(), anyInt())).thenAnswer(call -> {
            probes.countDown();
            return 1;
        });
        open();

        server.accept().close();

        probes.await();
    }

    @Test
    void theDeathOfTheLibrarysThreadEndsTheConnection() throws IOException {
        lenient().when(client.effectiveSend(any(), anyInt())).thenReturn(1);
        AtomicReference<Thread> reading = new AtomicReference<>();
        transport = new LiburbiTransport(new TcpConnector("127.0.0.1", server.getLocalPort()), (opened, heard) -> {
            reading.set(new Thread(() -> {
                throw new IllegalStateException("made up");
            }));
            return client;
        });
        open();

        reading.get().start();

        verify(receiver, timeout(WaitLimit.MS))
                .ended(argThat(cause -> String.valueOf(cause.getMessage())
                        .startsWith("liburbi-java stopped reading: java.lang.IllegalStateException")));
    }

    @Test
    void closingEndsTheLibrarysThreadBeforeItsSocketAndDeliversTheEndLast() throws IOException {
        boolean[] wasOpen = {false};
        doAnswer(call -> wasOpen[0] = socket.isOpen()).when(client).disconnect();
        open();
        listener.accept(text(1, "a", "1"));

        transport.close();
        transport.close();

        ArgumentCaptor<IOException> cause = ArgumentCaptor.captor();
        InOrder order = inOrder(receiver);
        order.verify(receiver, timeout(WaitLimit.MS)).received(any());
        order.verify(receiver, timeout(WaitLimit.MS)).ended(cause.capture());
        assertThat(cause.getValue()).hasMessage("closed");
        verify(client).disconnect();
        assertThat(wasOpen[0]).isTrue();
        assertThat(socket.isOpen()).isFalse();
    }

    @Test
    void anAbortResetsTheConnectionSoThatNothingIsDeliveredLate() throws IOException {
        open();
        try (Socket peer = server.accept()) {
            transport.abort();

            assertThatThrownBy(() -> peer.getInputStream().read())
                    .isInstanceOf(IOException.class)
                    .hasMessageContaining("reset");
        }
    }

    private static byte[] bytes(String text) {
        return text.getBytes(StandardCharsets.ISO_8859_1);
    }

    private static URBIEvent text(int timeMs, String tag, String text) {
        URBIEvent event = mock();
        when(event.getTimestamp()).thenReturn(timeMs);
        when(event.getTag()).thenReturn(tag);
        when(event.getCmd()).thenReturn(text);
        return event;
    }
}
