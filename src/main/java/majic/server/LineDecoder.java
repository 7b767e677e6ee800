package majic.server;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;

/**
 * Splits UTF-8 bytes into lines, in whatever portions they arrive. Lines longer than any valid one are truncated, to a
 * length at which MAJIC Script still refuses them.
 */
final class LineDecoder {
    /** Four bytes for each of the 4000 characters of a line of MAJIC Script, and some more. */
    private static final int LONGEST_LINE = 16_100;

    private final ByteArrayOutputStream begun = new ByteArrayOutputStream();

    /** Returns the lines that these bytes complete, without their line ends. */
    List<String> feed(ByteBuffer bytes) {
        List<String> lines = new ArrayList<>();
        while (bytes.hasRemaining()) {
            byte next = bytes.get();
            if (next == '\n') {
                lines.add(rest());
                begun.reset();
            } else if (begun.size() < LONGEST_LINE && next != '\r') {
                begun.write(next);
            }
        }
        return lines;
    }

    /** Returns the part of an incomplete line that has arrived. */
    String rest() {
        return begun.toString(StandardCharsets.UTF_8);
    }
}
