package majic.aibo.sound;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import majic.bot.BotException;
import org.jspecify.annotations.Nullable;

/**
 * Reads and writes the RIFF files that WAV files are. Lengths are not trusted: a chunk ends at the end of the file at
 * the latest, because programs that write while they record leave lengths of zero or the largest value.
 */
final class WaveFile {
    private static final int PCM = 1;
    private static final int FLOAT = 3;
    private static final int EXTENSIBLE = 0xFFFE;
    private static final int RIFF_HEADER = 12;
    private static final int CHUNK_HEADER = 8;
    private static final int SHORTEST_FORMAT = 16;
    private static final int SUB_FORMAT_AT = 24;

    private final String name;
    private final ByteBuffer file;
    private @Nullable PcmFormat format;

    private WaveFile(String name, byte[] bytes) {
        this.name = name;
        this.file = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
    }

    /** Whether it begins as such a file does. */
    static boolean isRiff(byte[] bytes) {
        return bytes.length >= RIFF_HEADER
                && word(bytes, 0).equals("RIFF")
                && word(bytes, 8).equals("WAVE");
    }

    /**
     * Reads a whole file.
     *
     * @param name what messages call it
     * @param bytes all of it
     * @throws BotException if it is no WAV file, or one whose sound is compressed, damaged or empty
     */
    static Pcm read(String name, byte[] bytes) {
        if (!isRiff(bytes)) {
            throw new BotException(name + ": not a WAV file");
        }
        return new WaveFile(name, bytes).read();
    }

    private Pcm read() {
        int at = RIFF_HEADER;
        while (at + CHUNK_HEADER <= file.capacity()) {
            String kind = word(file.array(), at);
            int start = at + CHUNK_HEADER;
            long length = Integer.toUnsignedLong(file.getInt(at + 4));
            int end = (int) Math.min(file.capacity(), start + length);
            if (kind.equals("fmt ")) {
                format = format(start, end);
            } else if (kind.equals("data")) {
                return data(start, isUnfinished(length) ? file.capacity() : end);
            }
            at = end + (int) (length & 1);
        }
        throw new BotException(name + ": a WAV file without sound in it");
    }

    private static boolean isUnfinished(long length) {
        return length == 0;
    }

    private PcmFormat format(int start, int end) {
        if (end - start < SHORTEST_FORMAT) {
            throw damaged();
        }
        int tag = file.getShort(start) & 0xFFFF;
        boolean extended = tag == EXTENSIBLE && end - start >= SUB_FORMAT_AT + 2;
        int encoding = extended ? file.getShort(start + SUB_FORMAT_AT) & 0xFFFF : tag;
        if (encoding != PCM && encoding != FLOAT) {
            throw new BotException(name + ": its sound is compressed (WAV format " + encoding
                    + "); save it as PCM, of 16 bits for instance");
        }
        int bits = file.getShort(start + 14) & 0xFFFF;
        PcmFormat told =
                new PcmFormat(file.getShort(start + 2) & 0xFFFF, file.getInt(start + 4), bits, coding(encoding, bits));
        if (!told.isSensible()) {
            throw new BotException(name + ": a WAV file of " + told.channels() + " channel(s), " + told.rateHz()
                    + " Hz and " + bits + " bits cannot be played; 16 bits and 16000 Hz are what the dog has");
        }
        return told;
    }

    private static PcmFormat.Coding coding(int encoding, int bits) {
        if (encoding == FLOAT) {
            return PcmFormat.Coding.FLOAT;
        }
        return bits == 8 ? PcmFormat.Coding.UNSIGNED : PcmFormat.Coding.SIGNED;
    }

    private Pcm data(int start, int end) {
        PcmFormat known = format;
        if (known == null) {
            throw damaged();
        }
        int whole = (end - start) / known.frameBytes() * known.frameBytes();
        if (whole == 0) {
            throw new BotException(name + ": a WAV file without sound in it");
        }
        return new Pcm(known, Arrays.copyOfRange(file.array(), start, start + whole));
    }

    private BotException damaged() {
        return new BotException(name + ": a damaged WAV file; its header is not whole");
    }

    private static String word(byte[] bytes, int at) {
        return new String(bytes, at, 4, StandardCharsets.ISO_8859_1);
    }

    /** A whole file for a sound with signed samples of 16 bits. */
    static byte[] write(Pcm sound) {
        PcmFormat format = sound.format();
        int length = sound.bytes().length;
        ByteBuffer file = ByteBuffer.allocate(RIFF_HEADER + CHUNK_HEADER + SHORTEST_FORMAT + CHUNK_HEADER + length)
                .order(ByteOrder.LITTLE_ENDIAN);
        file.put(ascii("RIFF")).putInt(file.capacity() - CHUNK_HEADER).put(ascii("WAVE"));
        file.put(ascii("fmt ")).putInt(SHORTEST_FORMAT).putShort((short) PCM).putShort((short) format.channels());
        file.putInt(format.rateHz()).putInt(format.rateHz() * format.frameBytes());
        file.putShort((short) format.frameBytes()).putShort((short) format.bits());
        file.put(ascii("data")).putInt(length).put(sound.bytes());
        return file.array();
    }

    private static byte[] ascii(String word) {
        return word.getBytes(StandardCharsets.US_ASCII);
    }
}
