package majic.pictures;

import static majic.pictures.PictureWindow.addToSelection;
import static majic.pictures.PictureWindow.awaitDialog;
import static majic.pictures.PictureWindow.awaitWindow;
import static majic.pictures.PictureWindow.click;
import static majic.pictures.PictureWindow.find;
import static majic.pictures.PictureWindow.select;

import com.formdev.flatlaf.FlatDarkLaf;
import com.formdev.flatlaf.FlatLaf;
import java.awt.Window;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.JSlider;
import javax.swing.JTabbedPane;
import javax.swing.JTextField;
import javax.swing.SwingUtilities;
import majic.gui.MajicFrame;
import majic.gui.editor.EditorContext;
import majic.gui.editor.EditorWindow;
import majic.gui.kit.StopButton;
import majic.gui.replay.ReplayServices;
import majic.gui.replay.ReplayWindow;
import majic.panel.PlotHost;
import majic.pictures.PictureWindow.Settled;
import majic.program.Program;
import majic.program.UserFolder;
import majic.program.WindowPicture;
import majic.recorder.Mark;
import majic.script.MajicParser;
import majic.simulation.SimulatedLab;
import majic.team.Member;
import majicsim.LabOptions;
import majicsim.LabPorts;
import org.junit.jupiter.api.Assertions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * Makes the pictures of the documents from a running lab: {@code mvn -Pscreenshots test}, on a machine with a display.
 */
class Screenshots {
    private static final Path IMAGES = Path.of("docs", "images");
    private static final LabOptions OPTIONS =
            LabOptions.standard().withPorts(LabPorts.FREE).withNoise(7);
    private static final int AIBO = 1;
    private static final int PIONEER = 2;

    @Test
    @Timeout(300)
    void paintsThePicturesOfTheDocuments(@TempDir Path home) throws Exception {
        try (Program program = new Program(new UserFolder(home), SimulatedLab.scaled(OPTIONS, 2), true)) {
            MajicParser parser = MajicParser.prompt(program.session());
            PictureWindow.decorate();
            MajicFrame frame = PictureWindow.open(program, parser);
            drive(program, parser);
            select(frame, PIONEER);
            awaitWindow(new Settled());
            WindowPicture.save(frame, IMAGES.resolve("main.png"));
            compare(frame);
            plot(program, parser, frame);
            withDialog(frame, "Add Bot", "add-bot.png");
            withDialog(frame, "Help", "help.png");
            editor(program, frame, home.resolve("lap.majic"));
            wrongLine(frame);
            parser.parseText("stop");
            awaitWindow(() -> find(frame, "release").isVisible());
            awaitWindow(new Settled());
            WindowPicture.save(frame, IMAGES.resolve("stopped.png"));
            replay(program, frame);
            dark(frame);
            SwingUtilities.invokeAndWait(frame::dispose);
        }
    }

    @Test
    void paintsTheStartPage(@TempDir Path home) throws Exception {
        try (Program program = new Program(new UserFolder(home), null, true)) {
            program.settings()
                    .put(
                            "team.last",
                            "add pioneer://10.0.0.5 as 1\nadd aibo://10.0.0.8 as 2\nadd hemisson:COM3 as 3\n");
            PictureWindow.decorate();
            MajicFrame frame = PictureWindow.open(program, MajicParser.prompt(program.session()));
            awaitWindow(() -> find(frame, "Yesterday's team").isEnabled());
            awaitWindow(new Settled());
            WindowPicture.save(frame, IMAGES.resolve("start-page.png"));
            SwingUtilities.invokeAndWait(frame::dispose);
        }
    }

    private static void compare(MajicFrame frame) throws Exception {
        select(frame, AIBO);
        addToSelection(frame, PIONEER);
        awaitWindow(new Settled());
        WindowPicture.save(frame, IMAGES.resolve("compare.png"));
        select(frame, PIONEER);
        awaitWindow(new Settled());
    }

    private static void drive(Program program, MajicParser parser) {
        PictureWindow.add(program, parser, List.of("aibo", "pioneer", "hemisson"));
        List.of("1 move 500", "2 move 1200", "3 move 300", "1 turn 90", "2 turn 60", "3 turn -90", "all move 400")
                .forEach(parser::parseText);
        awaitIdle(program);
        parser.parseText("1,2 get distanceFront");
        parser.parseText("lab");
        awaitIdle(program);
    }

    private static void awaitIdle(Program program) {
        awaitWindow(() -> program.team().members().stream().allMatch(Member::isIdle));
        awaitWindow(new Settled());
    }

    private static void withDialog(MajicFrame frame, String button, String picture) throws Exception {
        click(frame, button);
        Window dialog = (Window) awaitDialog(frame, button);
        awaitWindow(new Settled());
        WindowPicture.save(frame, IMAGES.resolve(picture));
        SwingUtilities.invokeAndWait(dialog::dispose);
    }

    /** Steps through a script, so that one line runs and the next one waits. */
    private static void editor(Program program, MajicFrame frame, Path file) throws Exception {
        Files.writeString(file, """
                # Two robots side by side; the Hemisson follows at the end.
                repeat 4
                  1,2 move 300mm
                  if 2 distanceFront < 800 or any bumped == yes
                    1,2 turn 90deg   # away from the wall
                  else
                    2 turn 20deg
                  end
                end
                wait 2s
                3 drive 60mm/s 20deg/s for 3s
                """);
        EditorContext context = new EditorContext(
                program.session(), program.settings(), () -> {}, line -> Optional.empty(), act -> {}, files -> {});
        EditorWindow[] made = new EditorWindow[1];
        SwingUtilities.invokeAndWait(() -> {
            made[0] = new EditorWindow(context, frame);
            made[0].setSize(1000, 480);
            made[0].open(file);
        });
        EditorWindow editor = made[0];
        JLabel status = (JLabel) find(editor, "scriptStatus");
        awaitWindow(() -> status.getText().equals("No mistakes"));
        for (String state : List.of("Paused before line 2", "Paused before line 3", "Paused before line 4, line 3")) {
            click(editor, "editor Step");
            awaitWindow(() -> status.getText().startsWith(state));
        }
        WindowPicture.save(editor, IMAGES.resolve("editor.png"));
        click(editor, "editor End");
        awaitIdle(program);
        SwingUtilities.invokeAndWait(editor::dispose);
    }

    /** Plots a drive of the Pioneer. */
    private static void plot(Program program, MajicParser parser, MajicFrame frame) throws Exception {
        PlotHost host = (PlotHost) SwingUtilities.getAncestorOfClass(PlotHost.class, find(frame, "pose" + PIONEER));
        SwingUtilities.invokeAndWait(() -> host.plot(List.of("speed", "turnRate", "distanceFront"), false));
        List.of("2 move -600", "2 turn 90", "2 move 300").forEach(parser::parseText);
        awaitIdle(program);
        Window plot = Arrays.stream(Window.getWindows())
                .filter(window -> "plot".equals(window.getName()))
                .findFirst()
                .orElseThrow();
        WindowPicture.save((JFrame) plot, IMAGES.resolve("plot.png"));
        SwingUtilities.invokeAndWait(plot::dispose);
    }

    private static void wrongLine(MajicFrame frame) throws Exception {
        JTextField line = (JTextField) find(frame, "commandLine");
        SwingUtilities.invokeAndWait(() -> {
            line.setText("1 set headPam 30");
            line.postActionEvent();
        });
        awaitWindow(new Settled());
        WindowPicture.save(frame, IMAGES.resolve("wrong-line.png"));
        SwingUtilities.invokeAndWait(() -> line.setText(""));
    }

    /** Replays what was recorded for the other pictures. */
    private static void replay(Program program, MajicFrame frame) throws Exception {
        double endS = program.recorder().orElseThrow().history().marks(0).stream()
                .mapToDouble(Mark::seconds)
                .max()
                .orElseThrow();
        Path file = program.recordings().files().get(0);
        ReplayServices services = new ReplayServices(
                program.settings(),
                program.session().factory().types(),
                () -> new StopButton(program.team(), program.team()::stopAllIfAny));
        SwingUtilities.invokeAndWait(() -> ReplayWindow.open(frame, file, services, () -> {}, Assertions::fail));
        awaitWindow(() -> PictureWindow.replay() != null);
        JFrame replay = Objects.requireNonNull(PictureWindow.replay());
        awaitWindow(new Settled());
        SwingUtilities.invokeAndWait(() -> {
            ((JTabbedPane) find(replay, "replayRobots")).setSelectedIndex(PIONEER - 1);
            ((JSlider) find(replay, "timeline")).setValue((int) (endS * 10 * 0.8));
        });
        awaitWindow(new Settled());
        WindowPicture.save(replay, IMAGES.resolve("replay.png"));
        SwingUtilities.invokeAndWait(replay::dispose);
    }

    private static void dark(MajicFrame frame) throws Exception {
        SwingUtilities.invokeAndWait(() -> {
            FlatDarkLaf.setup();
            FlatLaf.updateUI();
        });
        awaitWindow(new Settled());
        WindowPicture.save(frame, IMAGES.resolve("dark.png"));
    }
}
