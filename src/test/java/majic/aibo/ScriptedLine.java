package majic.aibo;

import java.io.IOException;
import java.io.InputStream;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicLong;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import majicsim.net.LineCount;

/** One connection to a scripted dog: bytes to commands, and messages to bytes, with the trouble there is. */
final class ScriptedLine {
    private static final Pattern BINARY = Pattern.compile(".*BIN (\\d+) [^;]*;", Pattern.DOTALL);

    private final ScriptedDog dog;
    private final Socket socket;
    private final ScriptedDog.Trouble trouble;
    private final ScriptedCommands commands;
    private final CountDownLatch closed = new CountDownLatch(1);
    private final AtomicLong consumed = new AtomicLong();
    private final AtomicLong written = new AtomicLong();
    private volatile boolean deaf;
    private boolean late;

    ScriptedLine(ScriptedDog dog, Socket socket, ScriptedDog.Trouble trouble) {
        this.dog = dog;
        this.socket = socket;
        this.trouble = trouble;
        this.commands = new ScriptedCommands(dog, this);
    }

    LineCount count() {
        boolean open = closed.getCount() > 0;
        String here = "127.0.0.1:" + socket.getLocalPort();
        return new LineCount(here, "127.0.0.1:" + socket.getPort(), consumed.get(), written.get(), open, deaf);
    }

    void serve() {
        try {
            converse();
        } catch (IOException e) {
            close();
        }
    }

    private void converse() throws IOException {
        try (InputStream in = socket.getInputStream()) {
            StringBuilder pending = new StringBuilder();
            for (int next = in.read(); next >= 0; next = in.read()) {
                awaitEndIfDeaf();
                pending.append((char) next);
                boolean whole = next == '\n';
                if (next == ';') {
                    takeBinary(pending, in);
                }
                if (whole) {
                    split(pending.toString());
                    pending.setLength(0);
                }
                consumed.incrementAndGet();
            }
        }
        close();
    }

    /** Comes before the line counts as there: time stands still until then. */
    void introduce() {
        switch (trouble) {
            case HANGS_UP -> close();
            case HALF_A_BANNER -> {
                write("[00005152:start] *** URBI Ker");
                close();
            }
            case GARBAGE_FIRST -> write("\u0001\u00ff]] \"[12 BIN 7\n");
            default -> {}
        }
        if (dog.introducesItself && trouble != ScriptedDog.Trouble.SAYS_NOTHING && !socket.isClosed()) {
            say("start", "*** URBI Kernel version " + (dog.speaks15 ? "1.5" : "1.0") + " rev. 153 ");
            say("ident", "*** ID: U94665654017648");
            say("power", "*** Battery at 87 %");
        }
    }

    private void takeBinary(StringBuilder pending, InputStream in) throws IOException {
        Matcher header = BINARY.matcher(pending);
        if (header.matches()) {
            byte[] bytes = in.readNBytes(Integer.parseInt(header.group(1)));
            dog.rememberBinary(this, pending.toString(), bytes);
            consumed.addAndGet(bytes.length);
            pending.setLength(0);
        }
    }

    void stopReading() {
        deaf = true;
    }

    private void awaitEndIfDeaf() {
        try {
            if (deaf) {
                closed.await();
            }
        } catch (InterruptedException e) {
            throw new IllegalStateException("a scripted dog is never interrupted", e);
        }
    }

    private void split(String text) {
        int depth = 0;
        int from = 0;
        for (int at = 0; at < text.length(); at++) {
            char next = text.charAt(at);
            depth += next == '{' || next == '(' ? 1 : next == '}' || next == ')' ? -1 : 0;
            if (depth == 0 && (next == ';' || next == ',')) {
                run(text.substring(from, at).strip());
                from = at + 1;
            }
        }
    }

    private void run(String command) {
        if (trouble == ScriptedDog.Trouble.HANGS_UP_AT_A_COMMAND) {
            close();
            return;
        }
        dog.remember(command);
        late |= dog.latenessMs > 0 && command.contains("robot.walk(");
        long delayMs = late ? dog.latenessMs : dog.heedlessnessMs;
        if (delayMs > 0) {
            dog.errands().later(delayMs, () -> commands.execute(command));
        } else {
            commands.execute(command);
        }
    }

    /** Sends a message under a tag; without one if the tag is empty. */
    void say(String tag, String body) {
        String name = tag.isEmpty() ? "" : ":" + tag;
        String message = String.format("[%08d%s] %s", dog.nowMs(), name, body) + (body.startsWith("BIN ") ? "" : "\n");
        dog.errands().later(dog.slownessMs, () -> write(message));
    }

    private synchronized void write(String message) {
        try {
            byte[] bytes = message.getBytes(StandardCharsets.ISO_8859_1);
            int piece = trouble == ScriptedDog.Trouble.SAYS_ALL_IN_SINGLE_BYTES ? 1 : bytes.length;
            for (int at = 0; at < bytes.length; at += piece) {
                written.addAndGet(piece);
                socket.getOutputStream().write(bytes, at, piece);
            }
        } catch (IOException e) {
            close();
        }
    }

    void close() {
        closed.countDown();
        try {
            socket.close();
        } catch (IOException e) {
            throw new IllegalStateException(e);
        }
    }
}
