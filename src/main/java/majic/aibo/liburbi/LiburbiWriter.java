package majic.aibo.liburbi;

import java.io.IOException;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.Consumer;
import java.util.function.Supplier;
import liburbi.UClient;
import majic.link.Link;

/**
 * Creates a client of the library and writes by it, both on a thread of its own: a write of the library does not return
 * while the peer takes no data, and the interruption of a thread that writes would close the socket. The library's
 * thread is in the group of this one, where its death is noticed.
 */
final class LiburbiWriter {
    private final ExecutorService thread;
    private final UClient client;
    private final Consumer<IOException> broken;

    private LiburbiWriter(ExecutorService thread, UClient client, Consumer<IOException> broken) {
        this.thread = thread;
        this.client = client;
        this.broken = broken;
    }

    /**
     * Creates the client.
     *
     * @param name of the connection
     * @param broken called once or more often when the connection can no longer be used, on any thread
     * @throws IOException if the library refuses, or is another version
     */
    static LiburbiWriter start(String name, Supplier<UClient> maker, Consumer<IOException> broken) throws IOException {
        ThreadGroup group = new ThreadGroup(name) {
            @Override
            public void uncaughtException(Thread dead, Throwable cause) {
                broken.accept(new IOException("liburbi-java stopped reading: " + cause, cause));
            }
        };
        ExecutorService thread = Executors.newSingleThreadExecutor(task -> {
            Thread writing = new Thread(group, task, name + " writer");
            writing.setDaemon(true);
            return writing;
        });
        try {
            UClient client = await(thread.submit(maker::get));
            return new LiburbiWriter(thread, client, broken);
        } catch (IOException e) {
            thread.shutdownNow();
            throw e;
        }
    }

    /**
     * Writes one message, within {@link Link#WRITE_DEADLINE_MS}.
     *
     * @throws IOException if it was not written; the connection is broken then
     */
    void write(byte[] bytes) throws IOException {
        try {
            await(submit(bytes));
        } catch (IOException e) {
            broken.accept(e);
            throw e;
        }
    }

    /** Writes a message without waiting. */
    void writeLater(byte[] bytes) {
        try {
            submit(bytes);
        } catch (IOException e) {
            broken.accept(e);
        }
    }

    private Future<?> submit(byte[] bytes) throws IOException {
        try {
            return thread.submit(() -> send(bytes));
        } catch (RejectedExecutionException e) {
            throw new IOException("the connection is closed", e);
        }
    }

    private Void send(byte[] bytes) throws IOException {
        try {
            client.effectiveSend(bytes, bytes.length);
            return null;
        } catch (IOException | RuntimeException | LinkageError e) {
            IOException cause = new IOException("the dog closed it", e);
            broken.accept(cause);
            throw cause;
        }
    }

    /** Waits for the other thread; an interruption is kept for later, since a stop must be written in any case. */
    private static <T> T await(Future<T> task) throws IOException {
        long endNanos = System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(Link.WRITE_DEADLINE_MS);
        boolean interrupted = false;
        try {
            while (true) {
                try {
                    return task.get(endNanos - System.nanoTime(), TimeUnit.NANOSECONDS);
                } catch (InterruptedException e) {
                    interrupted = true;
                }
            }
        } catch (TimeoutException e) {
            throw new IOException("the dog takes no more data", e);
        } catch (ExecutionException e) {
            throw e.getCause() instanceof IOException failure
                    ? failure
                    : new IOException("liburbi-java cannot be used: " + e.getCause(), e);
        } finally {
            if (interrupted) {
                Thread.currentThread().interrupt();
            }
        }
    }

    /** Ends the library's thread and this one's; the socket is still open afterwards. */
    void close() {
        client.disconnect();
        thread.shutdown();
    }
}
