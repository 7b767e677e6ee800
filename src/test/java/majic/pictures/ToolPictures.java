package majic.pictures;

import static majic.pictures.PictureWindow.awaitWindow;
import static majic.pictures.PictureWindow.find;

import java.awt.Window;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import javax.swing.AbstractButton;
import javax.swing.JFrame;
import javax.swing.JLabel;
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
        EditorWindow editor = open(script);
        painter.paint(editor, "editor");
        SwingUtilities.invokeAndWait(editor::dispose);
    }

    private EditorWindow open(Path script) throws Exception {
        EditorContext context = new EditorContext(
                program.session(), program.settings(), () -> {}, line -> Optional.empty(), act -> {}, files -> {});
        EditorWindow[] editor = new EditorWindow[1];
        SwingUtilities.invokeAndWait(() -> {
            editor[0] = new EditorWindow(context, frame);
            editor[0].setSize(900, 560);
            editor[0].open(script);
        });
        return editor[0];
    }

    /** Steps through a script that computes values. */
    void paintValues(Path script) throws Exception {
        Files.writeString(script, """
                # Two corners of a square; the way is half of the room ahead.
                argument most = 600mm from 100 to 2000 "the longest side"
                let turns = 0
                let side = min $most (1 distanceFront / 2)

                on 1 distanceFront < 300
                  print "near a wall after" $turns
                end

                to corner way angle
                  1 move ($way - 50)
                  1 turn $angle
                end

                while $turns < 2
                  let turns = $turns + 1
                  corner $side (90deg / $turns)
                end
                ask again = yes "Once more?" for 30s
                """);
        EditorWindow editor = open(script);
        JLabel status = (JLabel) find(editor, "scriptStatus");
        awaitWindow(() -> status.getText().equals("No mistakes"));
        for (int line : List.of(3, 4, 6, 15, 16, 17)) {
            SwingUtilities.invokeAndWait(((AbstractButton) find(editor, "editor Step"))::doClick);
            awaitWindow(() -> status.getText().equals("Paused before line " + line));
        }
        painter.paint(editor, "values");
        SwingUtilities.invokeAndWait(((AbstractButton) find(editor, "editor End"))::doClick);
        awaitWindow(() -> program.team().members().stream().allMatch(Member::isIdle));
        SwingUtilities.invokeAndWait(editor::dispose);
    }

    /** Asks for a distance, behind which another question waits, and then for a word. */
    void paintQuestions(MajicParser parser) throws Exception {
        parser.parseText("ask far = 300mm from 0 to 2000 \"How far ahead is the mark on the floor?\" for 600s");
        awaitWindow(() -> PictureWindow.isShowing(frame, "answerField"));
        painter.paint(frame, "question");
        parser.parseText("answer 5cm");
        parser.parseText("ask side = left or right or back \"Where is the door?\" for 600s");
        awaitWindow(() -> PictureWindow.isShowing(frame, "answer left"));
        painter.paint(frame, "question-choice");
        parser.parseText("answer left");
        awaitWindow(() -> !PictureWindow.isShowing(frame, "questionStrip"));
    }
}
