package majic.bot;

/**
 * The last value of a parameter, and whether it may be used as the present one. Immutable.
 *
 * <p>One rule holds for everything that a robot reports. A reading is current while the robot is connected and the time
 * since its measurement is not longer than its driver allows. A reading that is not current has no {@link #value()}:
 * {@link BotControl#get} returns {@link Value.Unknown} with the reason. So a condition is undecided, a guard fails, a
 * curve has a gap, logs and recordings contain no value, and other programs receive none. The last value is shown only
 * with its age, or greyed in a panel.
 *
 * <p>Values that MAJIC keeps itself are no readings and stay current without a connection: the limits of motions,
 * calibration, the size, the address, and the age of the last report. A setting that was sent to the robot is a
 * reading, also if the robot does not report it: without a connection it may have changed.
 *
 * @param last the last value; {@link Value.Unknown} if there is none
 * @param ageS seconds since it was measured, or since the robot's last report if its own time is not known; NaN if
 *     there was no report, and for what is no reading
 * @param outdated why the last value is not current, as half a sentence; empty if it is
 */
public record Reading(Value last, double ageS, String outdated) {

    /**
     * A value that may be used as the present one.
     *
     * @param value as it was read; may be unknown
     * @param ageS seconds since it was measured; NaN if that is not known
     * @return the reading
     */
    public static Reading current(Value value, double ageS) {
        return new Reading(value, ageS, "");
    }

    /**
     * Returns whether the last value may be used as the present one.
     *
     * @return false if the robot is not connected, or the value is too old
     */
    public boolean isCurrent() {
        return outdated.isEmpty();
    }

    /**
     * Returns the present value.
     *
     * @return the last value if it is current, otherwise {@link Value.Unknown} with the reason, which stays the same
     *     while the value grows older
     */
    public Value value() {
        return isCurrent() ? last : Value.unknown(outdated);
    }

    /**
     * Returns whether there is a last value.
     *
     * @return false if the robot never reported it, or only that it has none
     */
    public boolean hasLast() {
        return !(last instanceof Value.Unknown);
    }

    /**
     * Returns the age for users.
     *
     * @return seconds with one decimal below ten: {@code 3.2 s}; "an unknown time" if it is not known
     */
    public String age() {
        if (Double.isNaN(ageS)) {
            return "an unknown time";
        }
        double shownS = ageS < 10 ? Math.round(ageS * 10) / 10.0 : Math.rint(ageS);
        return Value.of(shownS, Unit.S).toString();
    }

    /**
     * Returns the reading as answers show it.
     *
     * @return for instance {@code 198 mm}, or {@code unknown (connection lost; 198 mm at the last report, 3.2 s ago)}
     */
    @Override
    public String toString() {
        return isCurrent() || !hasLast()
                ? value().toString()
                : "unknown (" + outdated + "; " + last + " at the last report, " + age() + " ago)";
    }
}
