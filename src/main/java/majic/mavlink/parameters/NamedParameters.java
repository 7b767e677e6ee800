package majic.mavlink.parameters;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.regex.Pattern;
import majic.bot.Parameter;
import majic.bot.ParameterException;
import majic.bot.Unit;
import majic.bot.Value;
import majic.driver.ParameterTable;
import majic.mavlink.session.AutopilotParameters;
import majic.time.WaitPolicy;

/**
 * The parameters of the autopilot: {@code get param/WP_SPEED}. There are more than a thousand, so each is read when it
 * is asked for, and listed from then on.
 */
public final class NamedParameters implements ParameterTable.Finder {
    private static final String PREFIX = "param/";
    private static final Pattern NAME = Pattern.compile("\\w{1,16}");

    private final VehicleAccess access;

    /** Finds names without asking the vehicle. */
    public NamedParameters(VehicleAccess access) {
        this.access = access;
    }

    @Override
    public Optional<Found> find(String name) {
        if (!name.toLowerCase(Locale.ROOT).startsWith(PREFIX)) {
            return Optional.empty();
        }
        String own = name.substring(PREFIX.length()).toUpperCase(Locale.ROOT);
        if (!NAME.matcher(own).matches()) {
            throw new ParameterException(
                    name, name + ": a parameter of an autopilot has up to 16 letters, digits and _, as param/WP_SPEED");
        }
        return Optional.of(new Found(
                described(own),
                access.read(open -> read(open.session().parameters(), own)),
                values -> set(own, values)));
    }

    /** Asks the vehicle for its list in the background; so the first call finds few. */
    @Override
    public List<Parameter> begunWith(String text) {
        if (!text.toLowerCase(Locale.ROOT).startsWith(PREFIX)) {
            return List.of();
        }
        String own = text.substring(PREFIX.length()).toUpperCase(Locale.ROOT);
        return access.names().stream()
                .filter(name -> name.startsWith(own) && NAME.matcher(name).matches())
                .map(name -> described(name).access(true, true, false))
                .toList();
    }

    private static Parameter described(String own) {
        return Parameter.number(
                PREFIX + own, Unit.NONE, "a parameter of the autopilot, in its unit; read when asked for");
    }

    /** What only observes or must not wait gets the value that came last. */
    private static Value read(AutopilotParameters parameters, String name) {
        boolean asks = WaitPolicy.isAllowed() && !WaitPolicy.isObserving();
        Optional<Double> value = asks ? parameters.read(name) : parameters.known(name);
        return value.filter(Double::isFinite)
                .map(number -> Value.of(number, Unit.NONE))
                .orElse(Value.unknown(asks ? AutopilotParameters.unanswered(name) : "not read yet"));
    }

    private void set(String name, List<Value> values) {
        access.open().session().parameters().set(name, values.get(0).number());
    }
}
