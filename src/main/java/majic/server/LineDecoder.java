package majic.server;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;

/** Cuts bytes of UTF-8 text into lines, however they arrive. A line is cut off where no sensible one reaches. */
final class LineDecoder {
    private static final int LONGEST_LINE = 10_000;

    private final ByteArrayOutputStream begun = new ByteArrayOutputStream();

    /** The lines that some bytes complete, without their line ends. */
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

    /** What has come of a line whose end is missing. */
    String rest() {
        return begun.toString(StandardCharsets.UTF_8);
    }
}
