package majic.driver;

import java.util.List;
import java.util.Objects;
import java.util.concurrent.CopyOnWriteArrayList;
import majic.bot.BotCommand;
import majic.bot.BotException;
import majic.text.Suggestion;

/** The commands that only one type of robot has. Thread-safe. */
final class CommandTable {
    private final List<DriverCommand> commands = new CopyOnWriteArrayList<>();

    /** Replaces a command of the same name. */
    void add(DriverCommand command) {
        remove(command.command().name());
        commands.add(command);
    }

    void remove(String name) {
        commands.removeIf(known -> known.command().name().equalsIgnoreCase(name));
    }

    List<BotCommand> all() {
        return commands.stream().map(DriverCommand::command).toList();
    }

    /**
     * Looks a command up.
     *
     * @param bot the name of the robot for the message
     * @param name its name, whatever the case
     * @throws BotException if there is none of that name; the message suggests one
     */
    DriverCommand find(String bot, String name) {
        Objects.requireNonNull(name, "command");
        return commands.stream()
                .filter(known -> known.command().name().equalsIgnoreCase(name))
                .findFirst()
                .orElseThrow(() -> new BotException(name + ": " + bot + " has no such command"
                        + Suggestion.didYouMean(
                                name, all().stream().map(BotCommand::name).toList())));
    }
}
