package majic.gui.replay;

import java.io.IOException;
import java.nio.file.Path;
import majic.bot.BotException;
import majic.recorder.AdjacentParts;
import majic.recorder.Recording;
import majic.text.IoReason;
import majic.text.Texts;

/** One file of a recording in memory, and the files before and after it. Immutable. */
record ReplayPart(Recording recording, AdjacentParts adjacent) {
    private static final Texts TEXTS = Texts.of(ReplayPart.class);

    /**
     * Reads a file. Blocks.
     *
     * @throws BotException if it cannot be read; the message says why
     */
    static ReplayPart read(Path file) {
        try {
            Recording recording = Recording.read(file);
            return new ReplayPart(recording, AdjacentParts.of(file, recording.head()));
        } catch (IOException e) {
            throw new BotException(file + ": " + IoReason.of(e), e);
        }
    }

    /** Returns the begin of the recording, with the number of the part if it has several. */
    String title() {
        String begin = ReplayTimes.day(recording.head().begin());
        return hasOthers() ? TEXTS.get("part", begin, recording.head().part()) : begin;
    }

    boolean hasOthers() {
        return recording.head().part() > 1
                || adjacent.previous().isPresent()
                || adjacent.next().isPresent();
    }
}
