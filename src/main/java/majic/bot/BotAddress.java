package majic.bot;

import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/**
 * The address of a robot, as users type it: {@code aibo://192.168.1.20}, {@code hemisson:COM3}, {@code sim:pioneer},
 * {@code pioneer+aria://10.0.0.5}. Immutable.
 *
 * @param scheme the word before the first colon, in lower case: a type of robot, with or without the library to drive
 *     it by behind a plus sign, or {@code sim}
 * @param rest all behind that colon
 */
public record BotAddress(String scheme, String rest) {
    /** The scheme of a robot in the simulated lab. */
    public static final String SIMULATED = "sim";

    private static final Pattern SCHEME = Pattern.compile("[A-Za-z][\\w+-]*");
    private static final Set<String> OF_OTHER_DESKS = Set.of("mqtt", "mqtts");

    /**
     * Takes an address apart.
     *
     * @param text as typed
     * @return the address
     * @throws BotException if it does not begin with a scheme, as {@code 10.0.0.5:8101} does not; the message shows
     *     what an address looks like
     */
    public static BotAddress parse(String text) {
        int colon = Objects.requireNonNull(text, "address").indexOf(':');
        if (colon <= 0
                || colon == text.length() - 1
                || !SCHEME.matcher(text.substring(0, colon)).matches()) {
            throw new BotException(
                    text + ": not a robot's address; it looks like pioneer://10.0.0.5:8101, hemisson:COM3 or sim:aibo");
        }
        return new BotAddress(text.substring(0, colon).toLowerCase(Locale.ROOT), text.substring(colon + 1));
    }

    /**
     * Returns the type of robot.
     *
     * @return the scheme, up to a plus sign
     */
    public String type() {
        int plus = scheme.indexOf('+');
        return plus < 0 ? scheme : scheme.substring(0, plus);
    }

    /**
     * Returns whether the robot belongs to another desk, which knows its type and keeps its place and its calibration.
     *
     * @return true for a robot that is reached through a broker
     */
    public boolean isOfAnotherDesk() {
        return OF_OTHER_DESKS.contains(scheme);
    }

    /**
     * Returns the maker's library by which the robot is to be driven.
     *
     * @return what follows the plus sign in the scheme; empty for the program's own client
     */
    public Optional<String> library() {
        int plus = scheme.indexOf('+');
        return plus < 0 ? Optional.empty() : Optional.of(scheme.substring(plus + 1));
    }

    /**
     * Returns the library, if it is one of those that there are for the robot.
     *
     * @param known the names of these
     * @return as {@link #library()}
     * @throws BotException if it is another; the message lists the right addresses
     */
    public Optional<String> libraryAmong(List<String> known) {
        library().filter(library -> !known.contains(library)).ifPresent(library -> {
            String others = known.stream()
                    .map(other -> " or " + type() + "+" + other + ":" + rest)
                    .collect(Collectors.joining());
            throw new BotException(this + ": there is no library " + library + " for it; it looks like " + type() + ":"
                    + rest + others);
        });
        return library();
    }

    @Override
    public String toString() {
        return scheme + ":" + rest;
    }
}
