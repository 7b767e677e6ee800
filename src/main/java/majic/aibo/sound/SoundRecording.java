package majic.aibo.sound;

import java.io.ByteArrayOutputStream;
import java.util.Arrays;
import majic.aibo.urbi.UrbiMessage;
import majic.aibo.urbi.UrbiValue;
import majic.bot.BotException;
import org.jspecify.annotations.Nullable;

/**
 * The sound recorded so far. The dog's time stamps give the place of each block: a repeated block is dropped and
 * missing ones are replaced by silence, so that the timing stays correct. Filled by the reader thread; thread-safe.
 */
final class SoundRecording {
    private final double seconds;
    private final Runnable whenDone;
    private final ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    private @Nullable PcmFormat format;
    private double coveredMs;
    private int blocks;
    private double lostMs;
    private @Nullable String failure;

    /**
     * A recording of so many seconds.
     *
     * @param whenDone called once it is full or has failed, by the reader's thread
     */
    SoundRecording(double seconds, Runnable whenDone) {
        this.seconds = seconds;
        this.whenDone = whenDone;
    }

    /** Takes a message of the microphone. */
    void take(UrbiMessage message) {
        if (!isDone()) {
            append(message);
            if (isDone()) {
                whenDone.run();
            }
        }
    }

    private synchronized void append(UrbiMessage message) {
        if (message.body() instanceof UrbiMessage.Failure wrong) {
            failure = "the dog refuses: " + wrong.text();
        } else if (message.body() instanceof UrbiMessage.Result result
                && result.value() instanceof UrbiValue.Binary block) {
            try {
                append(MicrophoneBlock.of(block), message.timeMs());
            } catch (BotException e) {
                failure = blocks == 0 ? e.getMessage() : null;
            }
        }
    }

    private void append(Pcm block, long timeMs) {
        double lengthMs = block.seconds() * 1000;
        if (format == null) {
            format = block.format();
            coveredMs = timeMs - lengthMs;
        }
        if (!block.format().equals(format)) {
            return;
        }
        long passed = Math.round((timeMs - coveredMs) / lengthMs);
        if (passed > 0) {
            int missing = (int) Math.min(passed - 1, (long) Math.ceil(seconds * 1000 / lengthMs));
            bytes.writeBytes(new byte[missing * block.bytes().length]);
            bytes.writeBytes(block.bytes());
            lostMs += missing * lengthMs;
            coveredMs += passed * lengthMs;
            blocks++;
        }
    }

    /** Whether nothing more is to be waited for. */
    synchronized boolean isDone() {
        return failure != null || format != null && bytes.size() >= wanted(format);
    }

    private int wanted(PcmFormat known) {
        return (int) Math.round(seconds * known.rateHz()) * known.frameBytes();
    }

    /** How many blocks have come. */
    synchronized int blocks() {
        return blocks;
    }

    /** How much of it is silent because blocks were lost, ms. */
    synchronized double lostMs() {
        return lostMs;
    }

    /** Why there will be no more; null if nothing is wrong. */
    synchronized @Nullable String failure() {
        return failure;
    }

    /** What there is, at most as much as was wanted; null if that is nothing. */
    synchronized @Nullable Pcm sound() {
        PcmFormat known = format;
        if (known == null) {
            return null;
        }
        byte[] all = bytes.toByteArray();
        return new Pcm(known, Arrays.copyOf(all, Math.min(all.length, wanted(known))));
    }
}
