package majic.log;

import java.io.Closeable;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.SeekableByteChannel;
import java.nio.charset.StandardCharsets;

/** A file that whole lines are appended to. Lines that cannot be written leave no part of themselves. Not thread-safe. */
final class LineFile implements Closeable {
    private final SeekableByteChannel channel;
    private long end;

    /**
     * Begins an empty file.
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
     * @throws IOException if not all of them could be written; the file is as before then, as far as the system allows,
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

    @Override
    public void close() throws IOException {
        channel.close();
    }
}
