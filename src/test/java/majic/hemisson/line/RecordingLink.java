package majic.hemisson.line;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import majic.link.Link;
import majic.link.Traffic;

/** A link that remembers what was written to it. */
final class RecordingLink implements Link {
    private final List<String> commands = new ArrayList<>();
    private Consumer<String> peer = command -> {};

    /** Sets what answers at once, before the write has returned. */
    void answeredBy(Consumer<String> peer) {
        this.peer = peer;
    }

    List<String> commands() {
        return commands;
    }

    @Override
    public void open(int timeoutMs) {
        commands.clear();
    }

    @Override
    public int read(byte[] buffer) {
        return -1;
    }

    @Override
    public void write(byte[] message) {
        String command = new String(message, StandardCharsets.ISO_8859_1).replace("\r", "");
        commands.add(command);
        peer.accept(command);
    }

    @Override
    public void close() {
        commands.add("closed");
    }

    @Override
    public void abort() {
        close();
    }

    @Override
    public String address() {
        return "recording";
    }

    @Override
    public Traffic traffic() {
        return new Traffic("here", "there", 0, 0, true);
    }
}
