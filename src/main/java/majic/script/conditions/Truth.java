package majic.script.conditions;

import org.jspecify.annotations.Nullable;

/**
 * What a condition comes to: yes, no, or undecided because a reading cannot be had. Immutable.
 *
 * @param holds whether it is true; means nothing when undecided
 * @param undecided why it is unknown; null if it is known
 */
public record Truth(boolean holds, @Nullable String undecided) {
    static final Truth YES = new Truth(true, null);
    static final Truth NO = new Truth(false, null);

    static Truth of(boolean holds) {
        return holds ? YES : NO;
    }

    static Truth unknown(String reason) {
        return new Truth(false, reason);
    }

    /** True as soon as one is, whatever is unknown of the other. */
    Truth or(Truth other) {
        if (this.equals(YES) || other.equals(YES)) {
            return YES;
        }
        return undecided != null ? this : other;
    }

    /** False as soon as one is, whatever is unknown of the other. */
    Truth and(Truth other) {
        if (this.equals(NO) || other.equals(NO)) {
            return NO;
        }
        return undecided != null ? this : other;
    }

    Truth not() {
        return undecided != null ? this : of(!holds);
    }
}
