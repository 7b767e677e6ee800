package majic.aibo;

import java.util.Arrays;
import java.util.List;

/** The postures that functions of the stick bring the dog into (URBI sheet 15). */
enum Posture {
    STAND("stand", 8),
    SIT("sit", 8),
    LAY("lay", 8),
    BEG("beg", 8),
    STRETCH("stretch", 8),
    INITIAL("initial", 8);

    private final String function;
    private final double longestS;

    Posture(String function, double longestS) {
        this.function = function;
        this.longestS = longestS;
    }

    static List<String> words() {
        return Arrays.stream(values()).map(Posture::function).toList();
    }

    static Posture of(String word) {
        return Arrays.stream(values())
                .filter(posture -> posture.function.equals(word))
                .findFirst()
                .orElse(STAND);
    }

    /** The function's name, and the word for it in MAJIC Script. */
    String function() {
        return function;
    }

    /** How long it may take, seconds. */
    double longestS() {
        return longestS;
    }
}
