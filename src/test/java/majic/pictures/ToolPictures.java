package majic.pictures;

import static majic.pictures.PictureWindow.awaitWindow;
import static majic.pictures.PictureWindow.find;

import java.awt.Window;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import javax.swing.JFrame;
import javax.swing.SwingUtilities;
import majic.gui.MajicFrame;
import majic.gui.editor.EditorContext;
import majic.gui.editor.EditorWindow;
import majic.panel.PlotHost;
import majic.pictures.DialogPictures.Painter;
import majic.program.Program;
import majic.script.MajicParser;
import majic.team.Member;

/** Opens a plot with curves and the script editor with a mistake in its script, for pictures of them. */
final class ToolPictures {
    private final Program program;
    private final MajicFrame frame;
    private final Painter painter;

    ToolPictures(Program program, MajicFrame frame, Painter painter) {
        this.program = program;
        this.frame = frame;
        this.painter = painter;
    }

    /** Plots a short drive of a robot. */
    void paintPlot(MajicParser parser, int robot) throws Exception {
        PictureWindow.select(frame, robot);
        awaitWindow(() -> PictureWindow.isShowing(frame, "pose" + robot));
        PlotHost host = (PlotHost) SwingUtilities.getAncestorOfClass(PlotHost.class, find(frame, "pose" + robot));
        SwingUtilities.invokeAndWait(() -> host.plot(List.of("speed", "turnRate", "heading"), false));
        List.of("move -100", "turn -30", "turn 30", "move 100")
                .forEach(motion -> parser.parseText(robot + " " + motion));
        awaitWindow(() -> program.team().members().stream().allMatch(Member::isIdle));
        JFrame plot = (JFrame) Arrays.stream(Window.getWindows())
                .filter(window -> "plot".equals(window.getName()) && window.isShowing())
                .findFirst()
                .orElseThrow();
        painter.paint(plot, "plot");
        SwingUtilities.invokeAndWait(plot::dispose);
    }

    void paintEditor(Path script) throws Exception {
        Files.writeString(script, """
                # Two robots side by side; the last line has a mistake.
                repeat 4
                  1,2 move 300mm
                  if 2 distanceFront < 800
                    1,2 turn 90deg
                  end
                end
                3 drive 60mm/s 20deg/s for 3x
                """);
        EditorContext context =
                new EditorContext(program.session(), program.settings(), () -> {}, act -> {}, files -> {});
        EditorWindow[] editor = new EditorWindow[1];
        SwingUtilities.invokeAndWait(() -> {
            editor[0] = new EditorWindow(context, frame);
            editor[0].setSize(1000, 480);
            editor[0].open(script);
        });
        painter.paint(editor[0], "editor");
        SwingUtilities.invokeAndWait(editor[0]::dispose);
    }
}
