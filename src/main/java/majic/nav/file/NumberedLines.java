package majic.nav.file;

import java.io.BufferedInputStream;
import java.io.Closeable;
import java.io.EOFException;
import java.io.FilterInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.zip.GZIPInputStream;
import java.util.zip.ZipException;
import org.jspecify.annotations.Nullable;

/** The lines of a text file, plain or compressed by gzip, with their numbers and with limits. Not thread-safe. */
final class NumberedLines implements Closeable {
    static final int LONGEST = 200_000;
    private static final int GZIP = 0x1f8b;
    private static final int BUFFER = 1 << 16;

    private final String name;
    private final int mostLines;
    private final CountedInput counted;
    private final InputStream in;
    private final long size;
    private int number;

    /** Counts what has been read, for the progress. */
    private static final class CountedInput extends FilterInputStream {
        private long count;

        CountedInput(InputStream in) {
            super(in);
        }

        @Override
        public int read() throws IOException {
            int value = super.read();
            count += value < 0 ? 0 : 1;
            return value;
        }

        @Override
        public int read(byte[] bytes, int from, int length) throws IOException {
            int read = super.read(bytes, from, length);
            count += Math.max(0, read);
            return read;
        }
    }

    private NumberedLines(String name, int mostLines, CountedInput counted, InputStream in, long size) {
        this.name = name;
        this.mostLines = mostLines;
        this.counted = counted;
        this.in = in;
        this.size = size;
    }

    static NumberedLines open(Path file, int mostLines) throws IOException {
        InputStream plain = regular(file);
        try {
            CountedInput counted = new CountedInput(plain);
            BufferedInputStream buffered = new BufferedInputStream(counted, BUFFER);
            buffered.mark(2);
            boolean compressed = (buffered.read() << 8 | buffered.read()) == GZIP;
            buffered.reset();
            InputStream in =
                    compressed ? new BufferedInputStream(new GZIPInputStream(buffered, BUFFER), BUFFER) : buffered;
            return new NumberedLines(name(file), mostLines, counted, in, Files.size(file));
        } catch (IOException | RuntimeException e) {
            plain.close();
            throw e;
        }
    }

    /** Opens a regular file; a pipe or a device would block. */
    static InputStream regular(Path file) throws IOException {
        if (!Files.exists(file)) {
            throw new NoSuchFileException(file.toString());
        }
        if (!Files.isRegularFile(file)) {
            throw new IOException(name(file) + " is not a regular file");
        }
        return Files.newInputStream(file);
    }

    static String name(Path file) {
        return String.valueOf(file.getFileName());
    }

    /** The next line without its end, or null. */
    @Nullable
    String next() throws IOException {
        byte[] bytes = new byte[256];
        int length = 0;
        int value = read();
        if (value < 0) {
            return null;
        }
        number++;
        if (number > mostLines) {
            throw wrong("there are more than " + mostLines + " lines; a file with fewer can be read");
        }
        for (; value >= 0 && value != '\n'; value = read()) {
            if (length == LONGEST) {
                throw wrong("is longer than " + LONGEST + " characters; is it a text file?");
            }
            if (length == bytes.length) {
                bytes = Arrays.copyOf(bytes, 2 * length);
            }
            bytes[length++] = (byte) value;
        }
        if (length > 0 && bytes[length - 1] == '\r') {
            length--;
        }
        return new String(bytes, 0, length, StandardCharsets.UTF_8);
    }

    private int read() throws IOException {
        try {
            return in.read();
        } catch (ZipException | EOFException e) {
            number++;
            throw wrong("the compressed file is damaged or cut off here; the whole one would be right");
        }
    }

    int number() {
        return number;
    }

    /** The share of the file that has been read, 0 to 1. */
    double progress() {
        return size == 0 ? 1 : Math.min(1, (double) counted.count / size);
    }

    /** An exception with the name of the file, the number of the line, and a sentence that continues these. */
    IOException wrong(String what) {
        return new IOException(name + ", line " + number + ": " + what);
    }

    double number(String text, String what, double least, double most) throws IOException {
        try {
            double value = Double.parseDouble(text);
            if (value >= least && value <= most) {
                return value;
            }
        } catch (NumberFormatException e) {
            // Refused below.
        }
        throw wrong(what + " is '" + shortened(text) + "', but has to be a number from " + text(least) + " to "
                + text(most));
    }

    private static String text(double value) {
        return value == Math.rint(value) && Math.abs(value) < 1e15 ? "" + (long) value : "" + value;
    }

    static String shortened(String text) {
        String plain = text.replaceAll("\\p{Cntrl}", "?");
        return plain.length() <= 40 ? plain : plain.substring(0, 40) + "…";
    }

    @Override
    public void close() throws IOException {
        in.close();
    }
}
