package majic.log;

import java.io.Closeable;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.SeekableByteChannel;
import java.nio.charset.StandardCharsets;

/**
 * Appends whole lines to a file. Lines that cannot be written completely leave no part in the file. Not thread-safe.
 */
final class LineFile implements Closeable {
    private final SeekableByteChannel channel;
    private long end;

    /**
     * Starts an empty file.
     *
     * @param channel is written from its start on
     */
    LineFile(SeekableByteChannel channel) {
        this.channel = channel;
    }

    /**
     * Appends lines.
     *
     * @param lines with their line ends
     * @throws IOException if not all of them could be written; the file is then as before, as far as the system allows,
     *     and another attempt may succeed
     */
    void append(String lines) throws IOException {
        ByteBuffer bytes = StandardCharsets.UTF_8.encode(lines);
        int length = bytes.remaining();
        try {
            channel.truncate(end).position(end);
            while (bytes.hasRemaining()) {
                channel.write(bytes);
            }
            end += length;
        } catch (IOException e) {
            channel.truncate(end);
            throw e;
        }
    }

    /** Returns the size of the file in bytes. */
    long size() {
        return end;
    }

    @Override
    public void close() throws IOException {
        channel.close();
    }
}
