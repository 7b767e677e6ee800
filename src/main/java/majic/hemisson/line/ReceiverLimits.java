package majic.hemisson.line;

/**
 * What the receiver of a robot is known to survive. Immutable.
 *
 * @param readsBehindBriefAnswers whether it reads a whole command that arrives while it answers D, H or L, because
 *     those answers are so short (Hemisson sheet 15)
 * @param ignoresArguments whether it ignores arguments behind a question and keeps them for a D without any (sheet 4.2)
 */
record ReceiverLimits(boolean readsBehindBriefAnswers, boolean ignoresArguments) {
    /** That of K-Team's firmware, which was measured. */
    static final ReceiverLimits K_TEAM = new ReceiverLimits(true, true);

    /** Any other; a third character while it answers may deafen it. */
    static final ReceiverLimits UNKNOWN = new ReceiverLimits(false, false);
}
