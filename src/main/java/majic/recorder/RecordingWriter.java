package majic.recorder;

import java.io.IOException;
import java.io.OutputStream;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.List;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.Semaphore;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import java.util.zip.GZIPOutputStream;
import majic.text.IoReason;
import majic.text.LateLogger;
import org.jspecify.annotations.Nullable;

/**
 * Writes the lines of a recording to compressed files, four times a second, on a thread of its own. What is written is
 * readable after one second, also if the program is killed. When the disk is too slow, lines are dropped and counted.
 * When a file cannot be written, that is reported once, and another file is tried a minute later. Thread-safe.
 */
final class RecordingWriter {
    private static final Logger LOG = LateLogger.of(RecordingWriter.class);
    private static final int MOST_UNWRITTEN = 2000;

    /** How long lines wait, so that the thread wakes up once for all of them. */
    private static final long WRITE_MS = 250;

    /** A little less than a second, so that each fourth time of writing flushes. */
    private static final long FLUSH_NANOS = 900_000_000;

    private static final long RETRY_NANOS = 60_000_000_000L;
    private static final long CLOSE_BOUND_MS = 1000;
    private static final int BUFFER = 1 << 16;

    private final RecordingFolder folder;
    private final Consumer<String> alarm;
    private final LongSupplier nanos;
    private final BlockingQueue<Runnable> work = new ArrayBlockingQueue<>(MOST_UNWRITTEN);
    private final Semaphore urgent = new Semaphore(0);
    private final List<Path> files = new CopyOnWriteArrayList<>();
    private final AtomicLong dropped = new AtomicLong();
    private final AtomicLong unreported = new AtomicLong();
    private final Thread thread = new Thread(this::run, "recording");
    private volatile boolean partIsOver = true;
    private volatile boolean ended;
    private boolean failing;
    private long failedNanos;
    private long flushNanos;
    private @Nullable CountedFile file;

    /** A compressed file and how many bytes it has. */
    private static final class CountedFile implements AutoCloseable {
        private final Path path;
        private final OutputStream bytes;
        private final GZIPOutputStream lines;
        private long count;

        CountedFile(Path path) throws IOException {
            this.path = path;
            this.bytes = Files.newOutputStream(path, StandardOpenOption.CREATE_NEW);
            this.lines = new GZIPOutputStream(new Counter(), BUFFER, true);
        }

        void write(String text) throws IOException {
            lines.write(text.getBytes(StandardCharsets.UTF_8));
        }

        void flush() throws IOException {
            lines.flush();
        }

        @Override
        public void close() throws IOException {
            try (bytes) {
                lines.close();
            }
        }

        /** Counts what reaches the file. */
        private final class Counter extends OutputStream {
            @Override
            public void write(int one) throws IOException {
                count++;
                bytes.write(one);
            }

            @Override
            public void write(byte[] some, int from, int length) throws IOException {
                count += length;
                bytes.write(some, from, length);
            }
        }
    }

    /**
     * Creates a writer that has not begun a file.
     *
     * @param alarm receives one sentence when nothing can be written, and one when it is possible again; called by the
     *     thread of this writer
     * @param nanos the clock by which it flushes and tries again, ns; the system's one, since files are written in real
     *     time also when a lab runs faster
     */
    RecordingWriter(RecordingFolder folder, Consumer<String> alarm, LongSupplier nanos) {
        this.folder = folder;
        this.alarm = alarm;
        this.nanos = nanos;
        this.flushNanos = nanos.getAsLong();
        thread.setDaemon(true);
        thread.setPriority(Thread.MIN_PRIORITY);
        thread.start();
    }

    /** Whether the next lines have to begin another file, with everything that is known at that time. */
    boolean needsPart() {
        return partIsOver;
    }

    /** Begins another file with these lines; returns false if they were dropped, since the disk is too slow. */
    boolean begin(RecordingHead head, String lines) {
        boolean taken = work.offer(() -> open(head, lines));
        if (taken) {
            partIsOver = false;
        }
        urgent.release();
        return taken;
    }

    /** Writes lines; returns false if they were dropped, since the disk is too slow. Never waits. */
    boolean write(String lines) {
        boolean taken = work.offer(() -> append(lines));
        if (!taken) {
            dropped.incrementAndGet();
            unreported.incrementAndGet();
        }
        if (work.size() > MOST_UNWRITTEN / 2) {
            urgent.release();
        }
        return taken;
    }

    /** How many pieces were dropped so far. */
    long dropped() {
        return dropped.get();
    }

    /**
     * The files of this recording so far that still exist; their content is complete up to this call. A file that is
     * begun meanwhile is left out, since nothing of it can be read yet. Blocks.
     */
    List<Path> files() {
        CompletableFuture<List<Path>> flushed = new CompletableFuture<>();
        Runnable flush = () -> {
            List<Path> complete = List.copyOf(files);
            flush();
            flushed.complete(complete);
        };
        List<Path> known = files;
        try {
            if (!ended && offerUrgent(flush)) {
                known = flushed.completeOnTimeout(files, CLOSE_BOUND_MS, TimeUnit.MILLISECONDS)
                        .join();
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
        return known.stream().filter(Files::exists).toList();
    }

    /** Writes what is left, for one second at most, and ends the thread. */
    void close() {
        try {
            if (offerUrgent(() -> ended = true)) {
                thread.join(CLOSE_BOUND_MS);
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private boolean offerUrgent(Runnable task) throws InterruptedException {
        boolean taken = work.offer(task, CLOSE_BOUND_MS, TimeUnit.MILLISECONDS);
        urgent.release();
        return taken;
    }

    private void run() {
        try {
            while (!ended) {
                urgent.tryAcquire(WRITE_MS, TimeUnit.MILLISECONDS);
                urgent.drainPermits();
                for (int left = work.size(); left > 0 && !ended; left--) {
                    work.remove().run();
                    flushIfDue();
                }
                flushIfDue();
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        } finally {
            closeFile();
        }
    }

    private void flushIfDue() {
        long now = nanos.getAsLong();
        if (now - flushNanos > FLUSH_NANOS) {
            flush();
            retry(now);
            flushNanos = now;
        }
    }

    /** After a failure, another file is begun a minute later. */
    private void retry(long now) {
        if (failing && now - failedNanos > RETRY_NANOS) {
            partIsOver = true;
        }
    }

    private void open(RecordingHead head, String lines) {
        closeFile();
        try {
            CountedFile opened = new CountedFile(folder.next(head));
            file = opened;
            files.add(opened.path);
            opened.write(head.text());
        } catch (IOException e) {
            failed(e);
            return;
        }
        append(lines);
        if (failing && file != null) {
            failing = false;
            alarm.accept("the recording goes on in " + file.path.getFileName());
        }
    }

    private void append(String lines) {
        CountedFile open = file;
        if (open == null) {
            return;
        }
        try {
            long missing = unreported.getAndSet(0);
            open.write(missing == 0 ? lines : RecordingFormat.missing(missing) + lines);
        } catch (IOException e) {
            failed(e);
        }
    }

    private void flush() {
        CountedFile open = file;
        if (open == null) {
            return;
        }
        try {
            open.flush();
            if (open.count > folder.mostBytesPerFile()) {
                partIsOver = true;
            }
        } catch (IOException e) {
            failed(e);
        }
    }

    private void failed(IOException problem) {
        closeFile();
        failedNanos = nanos.getAsLong();
        if (!failing) {
            failing = true;
            alarm.accept("nothing is recorded: " + folder.path() + " cannot be written (" + IoReason.of(problem)
                    + "); make room there or allow writing, MAJIC tries again every minute");
        }
    }

    private void closeFile() {
        CountedFile open = file;
        file = null;
        if (open == null) {
            return;
        }
        try {
            open.close();
        } catch (IOException e) {
            LOG.log(Level.DEBUG, "the end of a recording could not be written", e);
        }
    }
}
