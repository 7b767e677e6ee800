package majic.figures.ways;

import java.util.function.BiConsumer;

/** What each method of {@code majic} calls first while {@link CallRecord} records. */
public final class CallProbe {
    static BiConsumer<String, String> receiver = (type, method) -> {};

    private CallProbe() {}

    /**
     * Passes a call on.
     *
     * @param type the class
     * @param method the method
     */
    public static void entered(String type, String method) {
        receiver.accept(type, method);
    }
}
