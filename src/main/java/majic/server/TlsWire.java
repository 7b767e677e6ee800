package majic.server;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.SocketChannel;
import java.nio.charset.StandardCharsets;
import java.util.function.Consumer;
import javax.net.ssl.SSLEngine;
import javax.net.ssl.SSLEngineResult;
import javax.net.ssl.SSLEngineResult.HandshakeStatus;
import javax.net.ssl.SSLException;

/**
 * Bytes encrypted by TLS (RFC 8446), for programs on other computers. The computations of the handshake, which take
 * milliseconds, are handed to the server, which decides when they run.
 */
final class TlsWire implements Wire {
    /** First byte of a connection in TLS: the content type of a handshake (RFC 8446, 5.1). */
    private static final int HANDSHAKE = 22;

    private static final ByteBuffer NO_BYTES = ByteBuffer.allocate(0);

    private final SocketChannel socket;
    private final SSLEngine engine;
    private final Consumer<Runnable> tasks;
    private final ByteBuffer received;
    private final ByteBuffer unsent;
    private boolean begun;
    private boolean secure;
    private boolean busy;

    /**
     * Prepares the handshake, which the client begins.
     *
     * @param socket a connection in non-blocking mode
     * @param engine for the server's side
     * @param tasks runs a computation later, on the server's thread, and then calls {@link #read} again
     * @throws SSLException if the engine cannot be used
     */
    TlsWire(SocketChannel socket, SSLEngine engine, Consumer<Runnable> tasks) throws SSLException {
        this.socket = socket;
        this.engine = engine;
        this.tasks = tasks;
        int record = engine.getSession().getPacketBufferSize();
        received = ByteBuffer.allocate(record);
        unsent = ByteBuffer.allocate(record).limit(0);
        engine.beginHandshake();
    }

    /**
     * Receives at most one buffer of encrypted bytes and decrypts all complete records in it, so that what remains is
     * less than a record and the next arrival of bytes reports it.
     */
    @Override
    public int read(ByteBuffer target) throws IOException {
        int count = busy ? 0 : socket.read(received);
        refusePlainText();
        while (advance(target)) {
            // the next record or step of the handshake
        }
        boolean atEnd = count < 0 || engine.isInboundDone();
        return target.position() == 0 && atEnd ? -1 : target.position();
    }

    /** Answers a client that does not use TLS in a way that its user can read. */
    private void refusePlainText() throws IOException {
        if (begun || received.position() == 0) {
            return;
        }
        begun = true;
        if (received.get(0) != HANDSHAKE) {
            String why = "this port is for programs that use TLS; see \"Other computers\" in docs/other-programs.md\n";
            socket.write(ByteBuffer.wrap(why.getBytes(StandardCharsets.UTF_8)));
            socket.shutdownOutput();
            throw new SSLException("a client does not use TLS");
        }
    }

    /** Does one step; returns whether another one is possible now. */
    private boolean advance(ByteBuffer target) throws IOException {
        if (busy || engine.isInboundDone()) {
            return false;
        }
        return switch (engine.getHandshakeStatus()) {
            case NEED_TASK -> delegate();
            case NEED_WRAP -> encrypt(NO_BYTES);
            default -> decrypt(target);
        };
    }

    private boolean delegate() {
        Runnable task = engine.getDelegatedTask();
        busy = true;
        tasks.accept(() -> {
            task.run();
            busy = false;
        });
        return false;
    }

    private boolean decrypt(ByteBuffer target) throws IOException {
        received.flip();
        try {
            SSLEngineResult result = engine.unwrap(received, target);
            note(result);
            return result.getStatus() == SSLEngineResult.Status.OK;
        } catch (SSLException e) {
            sendAlert();
            throw e;
        } finally {
            received.compact();
        }
    }

    /** Sends the reason of a failed handshake, in the words of TLS. */
    private void sendAlert() throws IOException {
        if (engine.getHandshakeStatus() == HandshakeStatus.NEED_WRAP) {
            encrypt(NO_BYTES);
        }
    }

    /** Encrypts one record and sends it as far as the system takes it; returns whether there was room for it. */
    private boolean encrypt(ByteBuffer source) throws IOException {
        flush();
        if (unsent.hasRemaining()) {
            return false;
        }
        unsent.clear();
        try {
            note(engine.wrap(source, unsent));
        } finally {
            unsent.flip();
        }
        boolean done = unsent.hasRemaining();
        flush();
        return done;
    }

    private void note(SSLEngineResult result) {
        secure |= result.getHandshakeStatus() == HandshakeStatus.FINISHED;
    }

    @Override
    public void write(ByteBuffer source) throws IOException {
        flush();
        while (secure && source.hasRemaining() && encrypt(source)) {
            // the next record
        }
    }

    @Override
    public void flush() throws IOException {
        if (unsent.hasRemaining()) {
            socket.write(unsent);
        }
    }

    @Override
    public boolean hasUnsent() {
        return unsent.hasRemaining();
    }

    @Override
    public boolean isReady() {
        return secure;
    }

    @Override
    public boolean isBusy() {
        return busy;
    }

    @Override
    public void endOutput() throws IOException {
        engine.closeOutbound();
        encrypt(NO_BYTES);
    }

    @Override
    public boolean isOpen() {
        return socket.isOpen();
    }

    @Override
    public void close() throws IOException {
        try (socket) {
            if (socket.isOpen()) {
                endOutput();
            }
        }
    }
}
