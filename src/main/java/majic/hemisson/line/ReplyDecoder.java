package majic.hemisson.line;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;

/**
 * Cuts what the robot sends into lines, however the bytes arrive. Replies end with CR LF (Hemisson sheet 4.1); a line
 * longer than any reply is dropped whole. Used by one thread.
 */
final class ReplyDecoder {
    /** The longest reply there is, a full camera reading, has 411 characters (sheet 9). */
    static final int LONGEST = 1024;

    private final byte[] line = new byte[LONGEST];
    private int length;
    private boolean tooLong;

    /**
     * Takes in what arrived.
     *
     * @return the lines that are complete now, without their ends; the characters are Latin-1
     */
    List<String> feed(byte[] bytes, int count) {
        List<String> lines = new ArrayList<>();
        for (int index = 0; index < count; index++) {
            if (bytes[index] == '\n') {
                complete(lines);
            } else {
                append(bytes[index]);
            }
        }
        return lines;
    }

    private void append(byte value) {
        if (length == LONGEST) {
            tooLong = true;
        } else {
            line[length++] = value;
        }
    }

    private void complete(List<String> lines) {
        int end = length > 0 && line[length - 1] == '\r' ? length - 1 : length;
        if (!tooLong) {
            lines.add(new String(line, 0, end, StandardCharsets.ISO_8859_1));
        }
        length = 0;
        tooLong = false;
    }
}
