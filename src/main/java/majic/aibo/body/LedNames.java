package majic.aibo.body;

import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/** Names the dog's 26 LEDs as URBI does (URBI sheet 13). */
public final class LedNames {
    /** The LEDs of the face. */
    public static final List<String> FACE =
            IntStream.rangeClosed(1, 14).mapToObj(led -> "ledF" + led).toList();

    /** The coloured LEDs of the back, from the front. */
    public static final List<String> BACK_COLOUR = List.of("ledBFC", "ledBMC", "ledBRC");

    /** The white LEDs of the back, from the front. */
    public static final List<String> BACK_WHITE = List.of("ledBFW", "ledBMW", "ledBRW");

    private LedNames() {}

    /** Returns all of them, in the order of the list parameter {@code leds}. */
    public static List<String> all() {
        return Stream.of(FACE, BACK_COLOUR, BACK_WHITE, List.of("ledHC", "ledHW", "modeR", "modeG", "modeB", "ledWIFI"))
                .flatMap(List::stream)
                .toList();
    }
}
