package majic.aibo.sound;

import java.util.List;
import java.util.Locale;
import java.util.regex.Pattern;
import majic.bot.BotException;
import majic.bot.Parameter;
import majic.bot.Unit;
import majic.bot.Value;
import majic.driver.DriverCommand;
import majic.driver.Motion;

/** Plays a WAV file of this computer, or where there is none of that name, one on the dog's stick. */
public final class PlayCommand {
    private static final Pattern NAME_ON_STICK = Pattern.compile("[A-Za-z0-9_-]{1,40}(\\.[wW][aA][vV])?");
    private static final double LONGEST_S = 60;

    private final Speaker speaker;

    public PlayCommand(Speaker speaker) {
        this.speaker = speaker;
    }

    public DriverCommand command() {
        return new DriverCommand(
                "play",
                List.of(Parameter.text("file", "a WAV file here, or the name of one on the stick")),
                false,
                "plays a WAV file of up to 60 s from this computer, or a sound of the stick: bark, bark2, beep, start, "
                        + "client, welcome, battery, drum1, test, tecno",
                (arguments, motion) -> play(arguments.get(0).toString(), motion));
    }

    private String play(String name, Motion motion) {
        LocalFile file = LocalFile.named(name);
        if (file.isThere()) {
            return playHere(file, motion);
        }
        if (!NAME_ON_STICK.matcher(name).matches()) {
            throw new BotException(name + (file.isFolder() ? ": a folder, not a WAV file" : ": there is no such file"));
        }
        return playOfStick(name, motion);
    }

    private String playHere(LocalFile file, Motion motion) {
        Pcm read = WaveFile.read(file.name(), file.read());
        if (read.seconds() > LONGEST_S) {
            throw new BotException(String.format(
                    Locale.ROOT, "%s: lasts %.1f s; %.0f s is the most", file.name(), read.seconds(), LONGEST_S));
        }
        SpeakerSound sound = SpeakerSound.of(read);
        speaker.play(sound, motion);
        return Value.of(sound.seconds(), Unit.S) + " of sound, sent over";
    }

    private String playOfStick(String name, Motion motion) {
        String file = name.contains(".") ? name : name + ".wav";
        if (!speaker.playOfStick(file, motion)) {
            throw new BotException(name + ": there is no such file here and no " + file
                    + " on the dog's stick; a stick as it was sold has bark, bark2, beep, start, client, welcome, battery, "
                    + "drum1, test and tecno");
        }
        return file + " of the dog's stick";
    }
}
