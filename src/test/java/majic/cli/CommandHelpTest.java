package majic.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import majic.Majic;
import majic.program.UserFolder;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import picocli.CommandLine;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.UnmatchedArgumentException;

/** Each command of the command line offers the options that it uses, and no others. */
class CommandHelpTest {
    @TempDir
    private Path folder;

    private List<String> options(String... commands) {
        CommandLine line = Majic.commandLine(new UserFolder(folder));
        for (String command : commands) {
            line = line.getSubcommands().get(command);
        }
        return line.getCommandSpec().options().stream()
                .map(OptionSpec::longestName)
                .filter(name -> !Stream.of("--help", "--version").toList().contains(name))
                .toList();
    }

    @Test
    void theLabTakesTheOptionsOfTheSimulatedRobots() {
        assertThat(options("lab"))
                .contains("--exact", "--seed", "--pioneer-model", "--hemisson-model")
                .doesNotContain("--lab", "--add", "--listen", "--aria-home", "--no-recording");
    }

    @Test
    void aRunTakesAllOptionsOfAStart() {
        assertThat(options("run")).contains("--lab", "--add", "--listen", "--exact", "--no-recording");
    }

    @ParameterizedTest
    @CsvSource({"make,--class --output", "show,''"})
    void theActMakerTakesNoOptionsOfAStart(String command, String own) {
        assertThat(options("act", command))
                .doesNotContain("--lab", "--add", "--exact", "--listen")
                .contains(own.isEmpty() ? new String[0] : own.split(" "));
    }

    @Test
    void anOptionThatACommandDoesNotTakeIsRefusedBehindIt() {
        CommandLine line = Majic.commandLine(new UserFolder(folder));
        assertThatThrownBy(() -> line.parseArgs("act", "show", "--lab", "Nod.act"))
                .isInstanceOf(UnmatchedArgumentException.class);
    }
}
