package majic.program;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests which classes are loaded until the window was painted for the first time, since loading delays it. */
@Tag("jdk")
class OpenedWindowTest {
    /** The classes by which FlatLaf looks whether there is MigLayout. */
    private static final String LOOKED_FOR =
            "net\\.miginfocom\\.(swing\\.MigLayout|layout\\.(Component|Container)Wrapper)";

    @TempDir
    static Path folder;

    private static List<String> loaded = List.of();

    @BeforeAll
    static void openTheWindow() throws IOException, InterruptedException {
        Path classes = folder.resolve("classes");
        Path printed = folder.resolve("printed");
        ProcessBuilder program = new ProcessBuilder(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-XX:TieredStopAtLevel=1",
                "-Xlog:class+load:file=" + classes.toString().replace("\\", "/") + ":none",
                "-cp",
                System.getProperty("surefire.test.class.path", System.getProperty("java.class.path")),
                OpenedWindow.class.getName());
        program.environment().put("MAJIC_HOME", folder.toString());
        int status = program.redirectErrorStream(true)
                .redirectOutput(printed.toFile())
                .start()
                .waitFor();
        assertThat(status).as(Files.readString(printed)).isZero();
        try (Stream<String> lines = Files.lines(classes)) {
            loaded = lines.map(line -> line.split(" ")[0]).toList();
        }
    }

    @Test
    void theWindowWasBuiltAndPainted() {
        assertThat(loaded).contains("majic.gui.MajicFrame", "com.formdev.flatlaf.FlatLightLaf", "java.awt.BasicStroke");
    }

    @Test
    void noLibraryIsUsedButTheLookAndFeel() {
        assertNoneIsLoaded("(?!(java|javax|sun|jdk|majic|majicsim|com\\.sun|com\\.formdev\\.flatlaf)\\.)(?!"
                + LOOKED_FOR + "$).*");
    }

    @Test
    void theLoggingOfTheJdkIsNotInitialised() {
        assertNoneIsLoaded("java\\.util\\.logging\\.LogManager\\$RootLogger");
    }

    @Test
    void noXmlIsReadAndNoTimeIsFormatted() {
        assertNoneIsLoaded("(javax\\.xml|org\\.w3c|org\\.xml|com\\.sun\\.org\\.apache|java\\.time\\.format)\\..*");
    }

    @Test
    void theDisplayIsNotAskedForWhatDraggingNeeds() {
        assertNoneIsLoaded("sun\\.awt\\.X11\\.(XDnD|MotifDnD)Constants");
    }

    @Test
    void noDialogEditorOrPlotIsMade() {
        assertNoneIsLoaded("majic\\.gui\\.(add\\.AddBotDialog|bots\\.StripKeys|editor\\.ScriptArea|plot\\.PlotView)");
    }

    @Test
    void noTextIsMadeForMessagesAsLongAsThereIsNone() {
        assertNoneIsLoaded("majic\\.gui\\.command\\.(WrappingKit|MessageText\\$.*)");
    }

    @Test
    void javasStyleSheetForHtmlIsNotRead() {
        assertNoneIsLoaded("javax\\.swing\\.text\\.html\\.(HTMLEditorKit|StyleSheet|CSS).*");
    }

    @Test
    void noPanelOfARobotAndNoSimulatorIsMade() {
        assertNoneIsLoaded("(majicsim|majic\\.[a-z]+\\.panel)\\..*");
    }

    private static void assertNoneIsLoaded(String names) {
        assertThat(loaded.stream().filter(name -> name.matches(names)).toList()).isEmpty();
    }
}
