package majic.gui.bots;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Container;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import javax.swing.JLabel;
import javax.swing.SwingUtilities;
import majic.environment.Settings;
import majic.gui.MajicFrame;
import majic.gui.WindowWait;
import majic.gui.kit.EventThreadChecks;
import majic.pictures.PictureWindow;
import majic.program.Program;
import majic.program.UserFolder;
import majic.script.MajicParser;
import majic.simulation.SimulatedLab;
import majicsim.LabOptions;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests that a panel of the window keeps its important readings while the bar of a running act is shown above it. */
class ActBarWindowTest {
    private static final List<String> DISTANCES =
            List.of("distanceFront", "distanceBack", "distanceLeft", "distanceRight");

    @AutoClose
    private final EventThreadChecks checks = new EventThreadChecks();

    private final Locale before = Locale.getDefault();

    @AfterEach
    void restoreLanguage() {
        Locale.setDefault(before);
    }

    @ParameterizedTest
    @ValueSource(strings = {"en", "de"})
    void thePioneersFourDistancesAreShownBelowTheBarOfItsAct(String language, @TempDir Path home) throws Exception {
        Locale.setDefault(Locale.forLanguageTag(language));
        SimulatedLab lab = SimulatedLab.scaled(LabOptions.exactOnFreePorts(), 1);
        try (Program program = new Program(new UserFolder(home), lab, false)) {
            MajicParser parser = MajicParser.prompt(program.session());
            MajicFrame frame = PictureWindow.open(program, parser, Settings.inMemory());
            checks.windowIsOpen();
            SwingUtilities.invokeAndWait(() -> frame.setSize(1280, 800));
            PictureWindow.add(program, parser, List.of("pioneer"));
            parser.parseText("1 act PioneerWander");
            WindowWait.await("the bar of the act", () -> PictureWindow.isShowing(frame, "endAct1"));
            Container panel = (Container) PictureWindow.find(frame, "bot1");
            SwingUtilities.invokeAndWait(frame::validate);
            SwingUtilities.invokeAndWait(() -> DISTANCES.forEach(name -> {
                JLabel reading = (JLabel) PictureWindow.find(panel, name);
                assertThat(reading.isShowing()).as(name).isTrue();
                assertThat(reading.getParent().getHeight())
                        .as(name)
                        .isGreaterThanOrEqualTo(reading.getY() + reading.getHeight());
                assertThat(reading.getWidth()).as(name).isGreaterThanOrEqualTo(reading.getPreferredSize().width);
            }));
            SwingUtilities.invokeAndWait(frame::dispose);
        }
    }
}
