package majic.bot;

import java.util.stream.Collectors;
import majic.script.commands.ParameterGroup;

/** The tables that a robot's page carries, as its driver describes them. */
public final class RobotPage {
    private RobotPage() {}

    /** A row for each parameter, those of a numbered family in one. */
    public static String parameters(MajicBot bot) {
        return ParameterGroup.of(bot.parameters()).stream().map(RobotPage::row).collect(Collectors.joining("\n"));
    }

    /** A row for each command that only this robot has. */
    public static String commands(MajicBot bot) {
        return bot.commands().stream()
                .map(command -> "| `" + command.usage() + "` | " + (command.moves() ? "yes" : "") + " | "
                        + command.help() + " |")
                .collect(Collectors.joining("\n"));
    }

    private static String row(ParameterGroup group) {
        Parameter parameter = group.first();
        String names = group.name().replace(" … ", "` … `");
        String access = !parameter.writable() ? "" : parameter.moves() ? "yes, moves" : "yes";
        return "| `" + names + "` | " + values(parameter) + " | " + access + " | " + parameter.help() + " |";
    }

    private static String values(Parameter parameter) {
        String unit = parameter.unit().symbol();
        return switch (parameter.kind()) {
            case NUMBER -> ((parameter.range().equals(Range.ANY) ? "" : parameter.range() + " ") + unit).strip();
            case LIST -> unit;
            case YES_NO -> "yes/no";
            case ON_OFF -> "on/off";
            case CHOICE -> String.join(", ", parameter.choices());
            case TEXT -> "text";
        };
    }
}
