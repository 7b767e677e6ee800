package majic.nav.file;

import java.io.IOException;
import java.io.InputStream;
import majic.nav.file.MapServerFile.Picture;

/** Reads pictures in the format PGM, binary (P5) or text (P2), with up to 65535 grey levels (netpbm, pgm(5)). */
final class PortableGraymap {
    private static final int MOST_LEVEL = 65_535;
    private static final int BYTE = 255;

    private final InputStream in;
    private final String name;

    private PortableGraymap(InputStream in, String name) {
        this.in = in;
        this.name = name;
    }

    /** Reads what is behind the two characters that name the format. */
    static Picture read(InputStream in, String name, boolean binary) throws IOException {
        return new PortableGraymap(in, name).read(binary);
    }

    private Picture read(boolean binary) throws IOException {
        int width = number("the width", Integer.MAX_VALUE);
        int height = number("the height", Integer.MAX_VALUE);
        int most = number("the number of grey levels", MOST_LEVEL);
        Picture.check(name, width, height);
        if (most == 0) {
            throw new IOException(name + ": the picture has no grey levels; 255 is usual");
        }
        byte[] pixels = new byte[width * height];
        for (int index = 0; index < pixels.length; index++) {
            int level = binary ? level(most > BYTE, index, width) : number("pixel " + (index + 1), MOST_LEVEL);
            pixels[index] = (byte) (Math.min(level, most) * BYTE / most);
        }
        return new Picture(width, height, pixels);
    }

    private int level(boolean twoBytes, int index, int width) throws IOException {
        int level = in.read();
        int low = twoBytes ? in.read() : 0;
        if (level < 0 || low < 0) {
            throw new IOException(
                    name + ": the picture ends in row " + (index / width + 1) + "; the whole file would be right");
        }
        return twoBytes ? level << 8 | low : level;
    }

    /** A number with the one character behind it; comments in front of it are skipped. */
    private int number(String what, int most) throws IOException {
        int next = in.read();
        while (next == '#' || Character.isWhitespace(next)) {
            if (next == '#') {
                while (next >= 0 && next != '\n') {
                    next = in.read();
                }
            } else {
                next = in.read();
            }
        }
        long value = -1;
        while (next >= '0' && next <= '9' && value <= most) {
            value = Math.max(0, value) * 10 + next - '0';
            next = in.read();
        }
        if (value < 0 || value > most || !(next < 0 || Character.isWhitespace(next))) {
            throw new IOException(name + ": " + what + " of the picture is not a number from 0 to " + most);
        }
        return (int) value;
    }
}
