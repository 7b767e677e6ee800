package majic.aibo.body;

import java.util.Arrays;
import java.util.List;

/** The postures that functions of the stick bring the dog into (URBI sheet 15). */
public enum Posture {
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

    public static List<String> words() {
        return Arrays.stream(values()).map(posture -> posture.function).toList();
    }

    public static Posture of(String word) {
        return Arrays.stream(values())
                .filter(posture -> posture.function.equals(word))
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException("no posture: " + word));
    }

    /** The call that makes the dog take it. */
    public String call() {
        return "robot." + function + "()";
    }
}
