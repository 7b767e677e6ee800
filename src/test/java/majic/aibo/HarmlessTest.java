package majic.aibo;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** Tests that no string literal of the driver contains a command that the URBI sheet forbids. */
class HarmlessTest {
    private static final Pattern LITERAL = Pattern.compile("\"((?:\\\\.|[^\"\\\\])*)\"");
    private static final Pattern NEVER =
            Pattern.compile("\\b(undefall|stopall|reset|reboot|shutdown|disconnect|killall)\\b|stop notag|-> ?unit"
                    + "|\\.val = \\\\\"");

    /** Where it stands what is refused. */
    private static final Set<Path> REFUSALS = Set.of(Path.of("CommandFilter.java"), Path.of("RawText.java"));

    @Test
    void noCommandOfTheDriverIsForbiddenByTheSheet() throws IOException {
        List<String> literals = literals();

        assertThat(literals).hasSizeGreaterThan(100).contains("stop walk, stop turn,");
        assertThat(literals).noneMatch(literal -> NEVER.matcher(literal).find());
    }

    /** All of the packages but the lists of what is refused. */
    private static List<String> literals() throws IOException {
        List<String> literals = new ArrayList<>();
        try (Stream<Path> files = Files.walk(Path.of("src/main/java/majic/aibo"))) {
            for (Path file : files.filter(Files::isRegularFile)
                    .filter(path -> !REFUSALS.contains(path.getFileName()))
                    .toList()) {
                Matcher literal = LITERAL.matcher(Files.readString(file));
                while (literal.find()) {
                    literals.add(literal.group(1));
                }
            }
        }
        return literals;
    }
}
