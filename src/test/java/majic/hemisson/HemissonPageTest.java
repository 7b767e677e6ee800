package majic.hemisson;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import majic.bot.Parameter;
import majic.bot.Range;
import majic.hemisson.line.Reply;
import majic.hemisson.modules.Modules;
import majic.script.commands.ParameterGroup;
import org.junit.jupiter.api.Test;

/** The page about the Hemisson lists what the driver describes, word for word. */
class HemissonPageTest {
    private static final Path PAGE = Path.of("docs", "robots", "hemisson.md");

    @Test
    void listsEveryParameter() throws IOException {
        try (MajicHemisson bot = wellEquipped(false)) {
            assertThat(Files.readString(PAGE)).contains(parameters(bot));
        }
    }

    @Test
    void listsEveryCommandInBothDialects() throws IOException {
        try (MajicHemisson stock = wellEquipped(false);
                MajicHemisson roadNarrows = wellEquipped(true)) {
            assertThat(Files.readString(PAGE)).contains(commands(stock)).contains(commands(roadNarrows));
        }
    }

    static String parameters(MajicHemisson bot) {
        return ParameterGroup.of(bot.parameters()).stream()
                .map(HemissonPageTest::row)
                .collect(Collectors.joining("\n"));
    }

    static List<String> commands(MajicHemisson bot) {
        return bot.commands().stream()
                .map(command -> "| `" + command.usage() + "` | " + (command.moves() ? "yes" : "") + " | "
                        + command.help() + " |")
                .toList();
    }

    static MajicHemisson wellEquipped(boolean roadNarrows) {
        MajicHemisson bot = new MajicHemisson("hemisson://127.0.0.1:1");
        bot.equip(Modules.of(
                Reply.of(roadNarrows ? "j,L,C0,01,U,E0,06,T,C4,01,D,A0,01,G,D0,01,2,00,01" : "j,C0,E0,C4,A0,D0")));
        return bot;
    }

    private static String row(ParameterGroup group) {
        Parameter parameter = group.first();
        String names = group.name().replace(" … ", "` … `");
        String access = !parameter.writable() ? "" : parameter.readable() ? "yes" : "only";
        return "| `" + names + "` | " + values(parameter) + " | " + access + " | " + parameter.help() + " |";
    }

    private static String values(Parameter parameter) {
        String unit = parameter.unit().symbol();
        String range = parameter.range().equals(Range.ANY) ? "" : parameter.range() + " ";
        return switch (parameter.kind()) {
            case NUMBER, LIST -> (range + unit).strip();
            case YES_NO -> "yes/no";
            case ON_OFF -> "on/off";
            case CHOICE -> String.join(", ", parameter.choices());
            case TEXT -> "text";
        };
    }
}
