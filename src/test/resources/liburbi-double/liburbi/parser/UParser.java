package liburbi.parser;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import liburbi.UClient;
import liburbi.call.URBIEvent;

/** Cuts the stream into lines and binaries; a binary in a list, or a line feed in a text, it does not understand. */
public class UParser {
    private static final Pattern LINE = Pattern.compile("\\[(\\d+)(?::([^\\]]*))?\\] ?(.*)");

    private final UClient client;
    private final ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    private URBIEvent binary;

    public UParser(UClient client) {
        this.client = client;
    }

    public void take(byte next) {
        if (binary != null) {
            bytes.write(next);
            endOfBinary();
        } else if (next == '\n') {
            endOfLine(bytes.toString(StandardCharsets.US_ASCII));
        } else {
            bytes.write(next);
        }
    }

    private void endOfLine(String text) {
        bytes.reset();
        Matcher line = LINE.matcher(text);
        if (!line.matches()) {
            return;
        }
        URBIEvent event = new URBIEvent(Integer.parseInt(line.group(1)), line.group(2), line.group(3));
        if (event.isBinary()) {
            binary = event;
        } else {
            client.call(event);
        }
    }

    private void endOfBinary() {
        if (bytes.size() == binary.getSize()) {
            URBIEvent event = binary;
            event.setBinBuffer(bytes.toByteArray());
            binary = null;
            bytes.reset();
            client.call(event);
        }
    }
}
