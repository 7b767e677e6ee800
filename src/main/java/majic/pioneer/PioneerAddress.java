package majic.pioneer;

import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Optional;
import majic.bot.BotAddress;
import majic.bot.BotException;
import majic.pioneer.state.Model;
import majic.pioneer.state.Models;
import majic.pioneer.state.ParameterFile;
import org.jspecify.annotations.Nullable;

/**
 * The address of a Pioneer with its option: {@code pioneer://10.0.0.5?params=FILE}, {@code pioneer:COM3?params=FILE}.
 * Immutable.
 *
 * @param place the address without the option
 * @param parameters of the maker's file that it names; null without one
 */
record PioneerAddress(BotAddress place, @Nullable ParameterFile parameters) {
    private static final String PARAMS = "params=";

    /**
     * Reads an address, and the file that it names.
     *
     * @throws BotException if the option or the file is wrong; the message says what is right
     */
    static PioneerAddress parse(BotAddress address) {
        int mark = address.rest().indexOf('?');
        if (mark < 0) {
            return new PioneerAddress(address, null);
        }
        String option = address.rest().substring(mark + 1);
        if (!option.startsWith(PARAMS) || option.length() == PARAMS.length()) {
            throw new BotException(address + ": " + option + " is no option of an address; there is " + PARAMS
                    + "FILE, the maker's parameter file of the robot");
        }
        if (address.library().isPresent()) {
            throw new BotException(address + ": ARIA has parameter files of its own; leave out ?" + option);
        }
        BotAddress place = new BotAddress(address.scheme(), address.rest().substring(0, mark));
        return new PioneerAddress(place, ParameterFile.read(path(option.substring(PARAMS.length()))));
    }

    private static Path path(String text) {
        try {
            return Path.of(text);
        } catch (InvalidPathException e) {
            throw new BotException(text + ": not the name of a file: " + e.getReason(), e);
        }
    }

    /** The model that a robot announces, with the values of the file. */
    Model model(String subclass) {
        return parameters == null ? Models.of(subclass) : parameters.model(subclass);
    }

    /** Why a model that is not known cannot be driven by its odometry, and what helps. */
    String unscaled(String subclass) {
        return "the scale of its model " + subclass + " is not known, so move and turn are refused, and drive is slow;"
                + " give the scale by the maker's parameter file of the robot: remove it, then add " + place
                + "?params=" + subclass + ".p";
    }

    /** A warning if the file is for another model than the robot announces. */
    Optional<String> otherModel(String subclass) {
        return Optional.ofNullable(parameters)
                .flatMap(ParameterFile::subclass)
                .filter(named -> !named.equalsIgnoreCase(subclass.strip()))
                .map(named -> "its parameter file is for the model " + named + ", but it calls itself " + subclass
                        + "; is it the right file?");
    }
}
