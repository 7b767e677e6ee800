package majic.pictures;

import static majic.pictures.PictureWindow.awaitDialog;
import static majic.pictures.PictureWindow.awaitWindow;
import static majic.pictures.PictureWindow.click;
import static majic.pictures.PictureWindow.find;
import static majic.pictures.PictureWindow.select;

import com.formdev.flatlaf.FlatDarkLaf;
import com.formdev.flatlaf.FlatLaf;
import java.awt.Container;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import javax.swing.JComboBox;
import javax.swing.JList;
import javax.swing.JTextField;
import javax.swing.SwingUtilities;
import majic.act.ActDetails;
import majic.act.make.ActMaker;
import majic.gui.MajicFrame;
import majic.pictures.PictureWindow.Settled;
import majic.program.Program;
import majic.program.UserFolder;
import majic.program.WindowPicture;
import majic.script.MajicParser;
import majic.script.ScriptAct;
import majic.simulation.SimulatedLab;
import majicsim.LabOptions;
import majicsim.LabPorts;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * Makes the pictures of loading a behaviour onto a robot: {@code mvn -Pscreenshots test}, on a machine with a display.
 */
class ActPictures {
    private static final Path IMAGES = Path.of("docs", "images");
    private static final LabOptions OPTIONS =
            LabOptions.standard().withPorts(LabPorts.FREE).withNoise(7);
    private static final ActDetails SQUARE =
            new ActDetails("Square", "1.2", "Ada Lovelace", "Goes round and round a square.");
    private static final ActDetails RELAY =
            new ActDetails("Relay", "1.0", "Ada Lovelace", "One robot sets off when the other has arrived.");
    private static final String SOURCE = """
            import majic.act.Argument;
            import majic.act.MajicAct;
            import majic.bot.Unit;

            public class Square extends MajicAct {
                @Argument(value = "how long a side is", unit = Unit.MM, from = 100, to = 2000)
                private double side = 300;

                @Argument("whether it goes round to the left")
                private boolean left = true;

                @Override
                protected void behave() {
                    for (int number = 1; ; number++) {
                        say("on side " + number);
                        bot.move(side);
                        bot.turn(left ? 90 : -90);
                    }
                }
            }
            """;
    private static final String SCRIPT = "repeat\n1 move 300\n1 wait\n2 move 300\n2 wait\n1,2 turn 180\nend\n";

    @Test
    @Timeout(300)
    void paintsTheWayOfABehaviourOntoARobot(@TempDir Path home) throws Exception {
        Path source = acts(home);
        try (Program program = new Program(new UserFolder(home), SimulatedLab.scaled(OPTIONS, 2), false)) {
            MajicParser parser = MajicParser.prompt(program.session());
            PictureWindow.decorate();
            MajicFrame frame = PictureWindow.open(program, parser);
            PictureWindow.add(program, parser, List.of("aibo", "pioneer", "hemisson"));
            choose(frame, 2, "Relay");
            click(awaitDialog(frame, "Choose Act"), "loadChosen");
            awaitDialog(frame, "Assign Roles");
            save(frame, "roles.png");
            click(awaitDialog(frame, "Assign Roles"), "Cancel");
            choose(frame, 2, "Square");
            save(frame, "choose-act.png");
            click(awaitDialog(frame, "Choose Act"), "loadChosen");
            Container trust = awaitDialog(frame, "Trust this code?");
            save(frame, "trust.png");
            click(trust, "Agree and run");
            awaitWindow(() -> program.team().member(2).owner() != null);
            awaitWindow(new Settled());
            awaitWindow(new Settled());
            save(frame, "act-running.png");
            make(frame, source);
            save(frame, "make-act.png");
            click(awaitDialog(frame, "Make Act"), "Close");
            SwingUtilities.invokeAndWait(() -> {
                FlatDarkLaf.setup();
                FlatLaf.updateUI();
            });
            save(frame, "act-running-dark.png");
            SwingUtilities.invokeAndWait(frame::dispose);
        }
    }

    private static Path acts(Path home) throws Exception {
        Path folder = Files.createDirectories(home.resolve("acts"));
        Path source = Files.writeString(home.resolve("Square.java"), SOURCE);
        Files.write(folder.resolve("Square.act"), ActMaker.from(source).make("Square", SQUARE));
        Files.write(folder.resolve("Relay.act"), ActMaker.save(new ScriptAct("relay.majic", SCRIPT), RELAY));
        return source;
    }

    private static void choose(MajicFrame frame, int robot, String act) throws Exception {
        select(frame, robot);
        click(frame, "Load Act");
        click(awaitDialog(frame, "Load Act"), "OK");
        JList<?> list = (JList<?>) find(awaitDialog(frame, "Choose Act"), "acts");
        awaitWindow(() -> list.getModel().getSize() > 0);
        SwingUtilities.invokeAndWait(() -> {
            for (int index = 0; index < list.getModel().getSize(); index++) {
                if (list.getModel().getElementAt(index).toString().equals(act)) {
                    list.setSelectedIndex(index);
                }
            }
        });
    }

    private static void make(MajicFrame frame, Path source) throws Exception {
        SwingUtilities.invokeAndWait(() -> frame.getJMenuBar()
                .getMenu(2)
                .getItem(frame.getJMenuBar().getMenu(2).getItemCount() - 1)
                .doClick());
        Container dialog = awaitDialog(frame, "Make Act");
        JTextField from = (JTextField) find(dialog, "makeFrom");
        SwingUtilities.invokeAndWait(() -> {
            from.setText(source.toString());
            from.postActionEvent();
        });
        awaitWindow(() -> ((JComboBox<?>) find(dialog, "makeAct")).getItemCount() > 0);
        SwingUtilities.invokeAndWait(() -> {
            from.setText("/home/ada/Square.java");
            write(dialog, "makeAuthor", SQUARE.author());
            write(dialog, "makeDescription", SQUARE.description());
            write(dialog, "makeTarget", "/home/ada/.local/share/majic/acts/Square.act");
        });
    }

    private static void write(Container dialog, String field, String text) {
        ((JTextField) find(dialog, field)).setText(text);
    }

    private static void save(MajicFrame frame, String picture) throws Exception {
        awaitWindow(new Settled());
        WindowPicture.save(frame, IMAGES.resolve(picture));
    }
}
