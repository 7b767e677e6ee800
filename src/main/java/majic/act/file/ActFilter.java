package majic.act.file;

import java.io.ObjectInputFilter;
import java.util.function.Predicate;

/** Admits an act, the classes that belong to it, and plain values within bounds. A second check after the scan. */
public record ActFilter(Predicate<String> own) implements ObjectInputFilter {
    /** The most steps that the JDK counts for one object, since it counts its own steps too. */
    private static final int STEPS_FOR_AN_OBJECT = 4;

    @Override
    public Status checkInput(FilterInfo info) {
        boolean bounded = info.depth() <= PlainValues.MAX_DEPTH + STEPS_FOR_AN_OBJECT
                && info.references() <= (long) PlainValues.MAX_OBJECTS * STEPS_FOR_AN_OBJECT
                && info.streamBytes() <= PlainValues.MAX_BYTES
                && info.arrayLength() <= PlainValues.MAX_ARRAY;
        Class<?> type = info.serialClass();
        return bounded && (type == null || PlainValues.isMadeOfOne(type) || admits(type.getName()))
                ? Status.ALLOWED
                : Status.REJECTED;
    }

    boolean admits(String className) {
        return PlainValues.has(className) || own.test(PlainValues.element(className));
    }
}
