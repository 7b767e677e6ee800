package majic.pioneer;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import majic.bot.BotEnvironment;
import majic.bot.Parameter;
import majic.bot.ParameterGroup;
import majic.bot.Range;
import org.junit.jupiter.api.Test;

/** The page about the Pioneer lists what the driver describes, word for word. */
class PioneerPageTest {
    private static final Path PAGE = Path.of("docs", "robots", "pioneer.md");

    @Test
    void listsEveryParameter() throws IOException {
        try (MajicPioneer bot = wellEquipped()) {
            String table = ParameterGroup.of(bot.parameters()).stream()
                    .map(PioneerPageTest::row)
                    .collect(Collectors.joining("\n"));

            assertThat(Files.readString(PAGE)).contains(table);
        }
    }

    @Test
    void listsEveryCommand() throws IOException {
        try (MajicPioneer bot = wellEquipped()) {
            String table = bot.commands().stream()
                    .map(command -> "| `" + command.usage() + "` | " + (command.moves() ? "yes" : "") + " | "
                            + command.help() + " |")
                    .collect(Collectors.joining("\n"));

            assertThat(Files.readString(PAGE)).contains(table);
        }
    }

    private static MajicPioneer wellEquipped() {
        MajicPioneer bot = new MajicPioneer("//127.0.0.1:1", BotEnvironment.plain());
        bot.describe(new Equipment(Models.USUAL, new Bumpers(5, 5), true, true, true));
        return bot;
    }

    private static String row(ParameterGroup group) {
        Parameter parameter = group.first();
        String names = group.name().replace(" … ", "` … `");
        String access = !parameter.writable() ? "" : parameter.moves() ? "yes, moves" : "yes";
        return "| `" + names + "` | " + values(parameter) + " | " + access + " | " + parameter.help() + " |";
    }

    private static String values(Parameter parameter) {
        String unit = parameter.unit().symbol();
        List<String> choices = parameter.choices();
        return switch (parameter.kind()) {
            case NUMBER -> ((parameter.range().equals(Range.ANY) ? "" : parameter.range() + " ") + unit).strip();
            case LIST -> unit;
            case YES_NO -> "yes/no";
            case ON_OFF -> "on/off";
            case CHOICE -> String.join(", ", choices);
            case TEXT -> "text";
        };
    }
}
