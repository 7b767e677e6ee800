package majic.aibo.sound;

import java.util.List;
import java.util.regex.Pattern;
import majic.aibo.urbi.UrbiRefusal;
import majic.aibo.urbi.UrbiValue;

/** Reads the blocks of the dog's microphone, which are raw or WAV files depending on the version (URBI sheet 12). */
final class MicrophoneBlock {
    private static final Pattern NUMBER = Pattern.compile("\\d{1,6}");
    private static final PcmFormat DOCUMENTED = new PcmFormat(2, 16_000, 16, PcmFormat.Coding.SIGNED);
    private static final int NUMBERS = 4;
    private static final int UNSIGNED = 2;

    private MicrophoneBlock() {}

    /**
     * The sound in a block, in 16 bits.
     *
     * @throws majic.bot.BotException if it makes no sense
     */
    static Pcm of(UrbiValue.Binary block) {
        if (WaveFile.isRiff(block.bytes())) {
            return WaveFile.read("a block of the microphone", block.bytes()).in16Bits();
        }
        PcmFormat format = format(block.words());
        if (!format.isSensible() || block.bytes().length == 0 || block.bytes().length % format.frameBytes() != 0) {
            throw new UrbiRefusal("the dog's microphone speaks of " + String.join(" ", block.words()) + " in "
                    + block.bytes().length + " bytes, which makes no sense");
        }
        return new Pcm(format, block.bytes()).in16Bits();
    }

    /** Type, channels, rate, bits, signed; what a server leaves out is as the manual has it. */
    private static PcmFormat format(List<String> words) {
        List<Integer> numbers = words.stream()
                .filter(word -> NUMBER.matcher(word).matches())
                .map(Integer::valueOf)
                .toList();
        if (numbers.size() < NUMBERS) {
            return DOCUMENTED;
        }
        PcmFormat.Coding coding =
                numbers.get(NUMBERS - 1) == UNSIGNED ? PcmFormat.Coding.UNSIGNED : PcmFormat.Coding.SIGNED;
        return new PcmFormat(numbers.get(0), numbers.get(1), numbers.get(2), coding);
    }
}
