package majic.gui.editor;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.regex.Pattern;
import majic.bot.BotException;
import majic.file.RegularFile;
import majic.file.WholeFile;
import majic.script.ScriptAct;
import majic.text.IoReason;
import majic.text.Texts;
import majic.text.VisibleText;

/**
 * A script's file as it was last read or written. Keeps its line ends and its byte order mark. Immutable; its methods
 * may block.
 *
 * @param path the file, absolute
 * @param text the script, with line feeds between its lines
 * @param lineEnd what separates the lines in the file
 * @param mark whether the file begins with a byte order mark
 * @param isUtf8 false if the file was read as Latin-1; it is written as UTF-8
 */
record ScriptFile(Path path, String text, String lineEnd, boolean mark, boolean isUtf8) {
    private static final Texts TEXTS = Texts.of(ScriptFile.class);
    /** How scripts that are saved without an ending end. */
    static final String ENDING = ScriptAct.ENDING;

    private static final int LARGEST_BYTES = 1_000_000;
    private static final String MARK = "\uFEFF";
    private static final String WINDOWS = "\r\n";
    private static final Pattern LINE_END = Pattern.compile("\r\n?");

    /** What a file is now, compared with what was read or written last. */
    enum OnDisk {
        SAME,
        CHANGED,
        GONE
    }

    /**
     * Reads a script.
     *
     * @throws BotException if it cannot be read, or is no text
     */
    static ScriptFile read(Path file) {
        Path path = file.toAbsolutePath().normalize();
        byte[] bytes;
        try {
            bytes = RegularFile.read(path, LARGEST_BYTES + 1);
        } catch (NoSuchFileException e) {
            throw new BotException(TEXTS.get("file.missing", path), e);
        } catch (IOException e) {
            throw new BotException(TEXTS.get("file.unread", path, IoReason.of(e)), e);
        }
        if (bytes.length > LARGEST_BYTES) {
            throw new BotException(TEXTS.get("file.tooLong", path, LARGEST_BYTES));
        }
        return of(path, bytes);
    }

    private static ScriptFile of(Path path, byte[] bytes) {
        String content;
        boolean utf8 = true;
        try {
            content = StandardCharsets.UTF_8
                    .newDecoder()
                    .decode(ByteBuffer.wrap(bytes))
                    .toString();
        } catch (CharacterCodingException e) {
            content = new String(bytes, StandardCharsets.ISO_8859_1);
            utf8 = false;
        }
        if (content.indexOf('\0') >= 0) {
            throw new BotException(TEXTS.get("file.noText", path));
        }
        boolean mark = content.startsWith(MARK);
        String written = mark ? content.substring(1) : content;
        String text = LINE_END.matcher(written).replaceAll("\n");
        return new ScriptFile(path, text, written.contains(WINDOWS) ? WINDOWS : "\n", mark, utf8);
    }

    /** A script that is not in a file yet. */
    static ScriptFile fresh(Path path) {
        return new ScriptFile(path.toAbsolutePath().normalize(), "", System.lineSeparator(), false, true);
    }

    /** The same script in another file. */
    ScriptFile at(Path other) {
        return new ScriptFile(other.toAbsolutePath().normalize(), text, lineEnd, mark, isUtf8);
    }

    /**
     * Writes another text into the file, which is complete at every moment.
     *
     * @return the file with that text
     * @throws BotException if it cannot be written
     */
    ScriptFile write(String newText) {
        String content = (mark ? MARK : "") + newText.replace("\n", lineEnd);
        try {
            WholeFile.replace(path, content);
        } catch (IOException e) {
            throw new BotException(TEXTS.get("file.unwritten", path, IoReason.of(e)), e);
        }
        return new ScriptFile(path, newText, lineEnd, mark, true);
    }

    /** Compares the file with what was read or written last; a file that cannot be read counts as gone. */
    OnDisk onDisk() {
        try {
            return read(path).text.equals(text) ? OnDisk.SAME : OnDisk.CHANGED;
        } catch (BotException e) {
            return OnDisk.GONE;
        }
    }

    /** The name without its folder. */
    String name() {
        return VisibleText.of(String.valueOf(path.getFileName()));
    }

    /** Whether a file can be opened as a script, by its name. */
    static boolean isScript(Path file) {
        String name = file.toString().toLowerCase(Locale.ROOT);
        return List.of(ENDING, ".script").stream().anyMatch(name::endsWith);
    }

    /** Returns a file with the ending of scripts, which is added if the name has none of them. */
    static Path withEnding(Path file) {
        return isScript(file) ? file : file.resolveSibling(file.getFileName() + ENDING);
    }
}
