package majic.aibo;

import java.util.Arrays;
import java.util.List;

/** The postures that functions of the stick bring the dog into (URBI sheet 15). */
enum Posture {
    STAND("stand"),
    SIT("sit"),
    LAY("lay"),
    BEG("beg"),
    STRETCH("stretch"),
    INITIAL("initial");

    /** The function's name, and the word for it in MAJIC Script. */
    private final String function;

    Posture(String function) {
        this.function = function;
    }

    static List<String> words() {
        return Arrays.stream(values()).map(posture -> posture.function).toList();
    }

    static Posture of(String word) {
        return Arrays.stream(values())
                .filter(posture -> posture.function.equals(word))
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException("no posture: " + word));
    }

    /** The call that makes the dog take it. */
    String call() {
        return "robot." + function + "()";
    }
}
