package majic.aibo.sound;

import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;
import java.util.function.Supplier;
import majic.aibo.session.Microphone;
import majic.bot.BotException;
import majic.bot.Parameter;
import majic.bot.Unit;
import majic.bot.Value;
import majic.driver.DriverCommand;
import majic.driver.Motion;

/** Records the dog's microphone into a WAV file on this computer. */
public final class RecordCommand {
    private static final double LONGEST_S = 60;
    private static final double QUIET_S = 2;
    private static final PcmFormat NOTHING_YET = new PcmFormat(2, 16_000, 16, PcmFormat.Coding.SIGNED);

    private final Supplier<Microphone> microphone;
    private final Runnable changed;
    private final Consumer<String> notices;

    /**
     * Records nothing yet.
     *
     * @param microphone of the open connection; throws if there is none
     * @param changed wakes the threads that wait for the robot
     * @param notices shows a message to the user
     */
    public RecordCommand(Supplier<Microphone> microphone, Runnable changed, Consumer<String> notices) {
        this.microphone = microphone;
        this.changed = changed;
        this.notices = notices;
    }

    public DriverCommand command() {
        return new DriverCommand(
                "record",
                List.of(
                        Parameter.number("seconds", Unit.S, "for how long").within(1, LONGEST_S),
                        Parameter.text("file", "a WAV file that is not there yet")),
                false,
                "records the dog's microphone for 1 to 60 s into a new WAV file on this computer",
                (arguments, motion) -> record(
                        arguments.get(0).number(),
                        LocalFile.named(arguments.get(1).toString()),
                        motion));
    }

    /** Creates the file first, so that a file that cannot be written is detected before the recording. */
    private String record(double seconds, LocalFile file, Motion motion) {
        Microphone open = microphone.get();
        SoundRecording recording = new SoundRecording(seconds, changed);
        file.create(WaveFile.write(new Pcm(NOTHING_YET, new byte[0])));
        try {
            listen(open, recording, seconds, motion);
        } catch (BotException e) {
            notices.accept(unfinished(recording, file));
            throw e;
        }
        return kept(recording, file);
    }

    /** Describes the part of a recording that was not finished. */
    private static String unfinished(SoundRecording recording, LocalFile file) {
        try {
            return "the recording was not finished: " + kept(recording, file);
        } catch (BotException e) {
            return String.valueOf(e.getMessage());
        }
    }

    private static String kept(SoundRecording recording, LocalFile file) {
        Pcm sound = recording.sound();
        if (sound == null) {
            file.delete();
            return "nothing was heard, and there is no " + file.name();
        }
        file.replace(WaveFile.write(sound));
        String lost = recording.lostMs() == 0
                ? ""
                : String.format(Locale.ROOT, ", %.0f ms of it silent because they were lost", recording.lostMs());
        return Value.of(sound.seconds(), Unit.S) + " in " + file.name() + lost;
    }

    private static void listen(Microphone open, SoundRecording recording, double seconds, Motion motion) {
        open.start(recording::take, (long) ((seconds + QUIET_S) * 1000));
        try {
            for (int before = 0; !motion.await(recording::isDone, QUIET_S); before = recording.blocks()) {
                if (recording.blocks() == before) {
                    throw new BotException("the dog's microphone has sent nothing for " + (int) QUIET_S + " s");
                }
            }
        } finally {
            open.stop();
        }
        String failure = recording.failure();
        if (failure != null) {
            throw new BotException(failure);
        }
    }
}
