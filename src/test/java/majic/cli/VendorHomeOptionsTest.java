package majic.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Map;
import java.util.Properties;
import majic.bot.BotException;
import majic.program.Program;
import majic.program.UserFolder;
import majic.vendor.VendorLibrary;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import picocli.CommandLine;

/** Tests the options for the folders in which makers' libraries are installed, from the command line to the search. */
class VendorHomeOptionsTest {
    private static final Map<VendorLibrary, String> ROBOTS = Map.of(
            VendorLibrary.ARIA, "pioneer+aria://127.0.0.1:1", VendorLibrary.LIBURBI, "aibo+liburbi://127.0.0.1:1");

    /** The options set system properties. */
    private final Properties before = (Properties) System.getProperties().clone();

    @TempDir
    private Path folder;

    @AfterEach
    void restoreProperties() {
        System.setProperties(before);
    }

    @ParameterizedTest
    @EnumSource
    void theLibraryIsLookedForInTheFolderThatTheOptionNames(VendorLibrary library) throws IOException {
        MajicCommand command = new MajicCommand(new UserFolder(folder));
        Path home = folder.resolve("none");
        new CommandLine(command).parseArgs(library.option(), home.toString());

        try (Program program = command.start().program(new UserFolder(folder), false)) {
            assertThatThrownBy(() -> program.session().factory().create(ROBOTS.get(library)))
                    .isInstanceOf(BotException.class)
                    .hasMessageEndingWith(library.label() + " is not found: there is no folder " + home + " (from "
                            + library.option() + ")");
        }
    }

    @ParameterizedTest
    @EnumSource
    void aSubcommandTakesTheOptionToo(VendorLibrary library) throws IOException {
        MajicCommand command = new MajicCommand(new UserFolder(folder));
        new CommandLine(command)
                .addSubcommand(new RunCommand(new UserFolder(folder)))
                .parseArgs("run", library.option(), "installed", "square.majic");
        command.start().program(new UserFolder(folder), false).close();

        assertThat(System.getProperty(library.property())).isEqualTo("installed");
    }

    @ParameterizedTest
    @EnumSource
    void withoutTheOptionTheEnvironmentOrTheSettingsDecide(VendorLibrary library) throws IOException {
        System.clearProperty(library.property());
        MajicCommand command = new MajicCommand(new UserFolder(folder));
        new CommandLine(command).parseArgs();
        command.start().program(new UserFolder(folder), false).close();

        assertThat(System.getProperty(library.property())).isNull();
    }

    @ParameterizedTest
    @EnumSource
    void helpNamesTheOptionAndKeepsItsExampleInOneLine(VendorLibrary library) {
        String help = new CommandLine(new MajicCommand(new UserFolder(folder))).getUsageMessage();

        assertThat(help).contains(library.option() + "=DIR", "+" + library.word() + "://");
    }
}
