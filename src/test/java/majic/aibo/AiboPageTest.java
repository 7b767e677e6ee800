package majic.aibo;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Collectors;
import majic.bot.BotEnvironment;
import majic.bot.Parameter;
import majic.bot.ParameterGroup;
import majic.bot.Range;
import org.junit.jupiter.api.Test;

/** The page about the Aibo lists what the driver describes, word for word. */
class AiboPageTest {
    private static final Path PAGE = Path.of("docs", "robots", "aibo.md");

    @Test
    void listsEveryParameter() throws IOException {
        try (MajicAibo dog = new MajicAibo("//127.0.0.1:1", BotEnvironment.plain())) {
            String table = ParameterGroup.of(dog.parameters()).stream()
                    .map(AiboPageTest::row)
                    .collect(Collectors.joining("\n"));

            assertThat(Files.readString(PAGE)).contains(table);
        }
    }

    @Test
    void listsEveryCommand() throws IOException {
        try (MajicAibo dog = new MajicAibo("//127.0.0.1:1", BotEnvironment.plain())) {
            assertThat(dog.commands())
                    .isNotEmpty()
                    .allSatisfy(command -> assertThat(Files.readString(PAGE))
                            .contains("| `" + command.usage() + "` | " + (command.moves() ? "yes" : "") + " | "
                                    + command.help() + " |"));
        }
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
