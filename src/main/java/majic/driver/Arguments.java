package majic.driver;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.function.IntFunction;
import majic.bot.BotCommand;
import majic.bot.BotException;
import majic.bot.Parameter;
import majic.bot.ParameterException;
import majic.bot.Value;
import org.jspecify.annotations.Nullable;

/** Checks what is handed to {@code set} and to a robot's own commands, before anything is sent. */
final class Arguments {
    private Arguments() {}

    static List<Value> forSet(Parameter parameter, List<Value> given) {
        Objects.requireNonNull(given, "values");
        if (given.isEmpty()) {
            throw new ParameterException(parameter.name(), parameter.name() + ": a value is missing");
        }
        List<Parameter> wanted = new ArrayList<>(parameter.extras());
        wanted.add(0, parameter);
        if (given.size() > wanted.size()) {
            throw new ParameterException(
                    parameter.name(), parameter.name() + ": takes " + wanted.size() + " value(s), not " + given.size());
        }
        return fit(wanted::get, given);
    }

    static List<Value> forCommand(BotCommand command, List<Value> given) {
        Objects.requireNonNull(given, "arguments");
        if (!command.takes(given.size())) {
            String names = command.argumentNames();
            throw new BotException(command.name() + ": takes " + (names.isEmpty() ? "nothing behind it" : names)
                    + hint(command, given));
        }
        return fit(command::argument, given);
    }

    /** A text of several words looks like several values. */
    private static String hint(BotCommand command, List<Value> given) {
        boolean tooMany = !given.isEmpty() && command.argument(given.size() - 1) == null;
        boolean takesText = command.arguments().stream().anyMatch(argument -> argument.kind() == Parameter.Kind.TEXT);
        return tooMany && takesText ? "; what has blanks in it goes in quotes" : "";
    }

    private static List<Value> fit(IntFunction<@Nullable Parameter> wanted, List<Value> given) {
        List<Value> fitted = new ArrayList<>();
        for (int index = 0; index < given.size(); index++) {
            fitted.add(
                    Objects.requireNonNull(wanted.apply(index)).fit(Objects.requireNonNull(given.get(index), "value")));
        }
        return List.copyOf(fitted);
    }
}
