package majic;

import com.formdev.flatlaf.FlatDarkLaf;
import com.formdev.flatlaf.FlatLaf;
import java.awt.Component;
import java.awt.Container;
import java.awt.Window;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.function.BooleanSupplier;
import javax.swing.AbstractButton;
import javax.swing.JDialog;
import javax.swing.JFrame;
import javax.swing.JTabbedPane;
import javax.swing.JTextField;
import javax.swing.SwingUtilities;
import majic.bot.Member;
import majic.gui.MajicFrame;
import majic.gui.Patience;
import majic.gui.Surroundings;
import majic.gui.Surroundings.SerialPortChoice;
import majic.script.MajicParser;
import majicsim.LabOptions;
import majicsim.LabPorts;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** Makes the pictures of the documents from a running lab: {@code mvn -Pscreenshots test}, on a machine with a display. */
class Screenshots {
    private static final Path IMAGES = Path.of("docs", "images");
    private static final LabOptions OPTIONS =
            LabOptions.standard().withPorts(LabPorts.FREE).withNoise(7);
    private static final int PIONEERS_TAB = 1;
    private static final int PATIENCE_S = 60;

    @Test
    @Timeout(300)
    void paintsThePicturesOfTheDocuments(@TempDir Path home) throws Exception {
        try (Program program = new Program(new UserFolder(home), SimulatedLab.scaled(OPTIONS, 2))) {
            MajicParser parser = new MajicParser(program.session(), true);
            MajicFrame frame = open(program, parser);
            drive(program, parser);
            JTabbedPane tabs = (JTabbedPane) find(frame, "bots");
            SwingUtilities.invokeAndWait(() -> tabs.setSelectedIndex(PIONEERS_TAB));
            awaitWindow(new Settled());
            WindowPicture.save(frame, IMAGES.resolve("main.png"));
            withDialog(frame, "Add Bot", "add-bot.png");
            withDialog(frame, "Help", "help.png");
            wrongLine(frame);
            parser.parseText("stop");
            awaitWindow(() -> find(frame, "release").isVisible());
            awaitWindow(new Settled());
            WindowPicture.save(frame, IMAGES.resolve("stopped.png"));
            dark(frame);
            SwingUtilities.invokeAndWait(frame::dispose);
        }
    }

    private static MajicFrame open(Program program, MajicParser parser) throws Exception {
        JFrame.setDefaultLookAndFeelDecorated(true);
        JDialog.setDefaultLookAndFeelDecorated(true);
        MajicFrame[] frame = new MajicFrame[1];
        SwingUtilities.invokeAndWait(() -> {
            MajicFrame.installLook(program.settings());
            Surroundings surroundings = new Surroundings(
                    () -> List.of(new SerialPortChoice("/dev/ttyUSB0", "USB serial port")),
                    null,
                    program::quit,
                    program.settings());
            frame[0] = new MajicFrame(program.session(), parser, surroundings);
            frame[0].setVisible(true);
        });
        return frame[0];
    }

    private static void drive(Program program, MajicParser parser) {
        for (String type : List.of("aibo", "pioneer", "hemisson")) {
            int wanted = program.team().members().size() + 1;
            parser.parseText("add sim:" + type);
            awaitWindow(() -> program.team().members().size() == wanted);
        }
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

    /** Becomes true when what was said has had the time to be shown. */
    private static final class Settled implements BooleanSupplier {
        private final long startNanos = System.nanoTime();

        @Override
        public boolean getAsBoolean() {
            return System.nanoTime() - startNanos > 1_500_000_000L;
        }
    }

    private static void withDialog(MajicFrame frame, String button, String picture) throws Exception {
        SwingUtilities.invokeAndWait(() -> ((AbstractButton) find(frame, button)).doClick());
        awaitWindow(() -> dialog(frame) != null);
        awaitWindow(new Settled());
        WindowPicture.save(frame, IMAGES.resolve(picture));
        SwingUtilities.invokeAndWait(() -> Objects.requireNonNull(dialog(frame)).dispose());
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

    private static void dark(MajicFrame frame) throws Exception {
        SwingUtilities.invokeAndWait(() -> {
            FlatDarkLaf.setup();
            FlatLaf.updateUI();
        });
        awaitWindow(new Settled());
        WindowPicture.save(frame, IMAGES.resolve("dark.png"));
    }

    private static void awaitWindow(BooleanSupplier condition) {
        Patience.await("the next picture", condition, PATIENCE_S);
    }

    private static @Nullable Window dialog(MajicFrame frame) {
        for (Window window : frame.getOwnedWindows()) {
            if (window instanceof JDialog && window.isShowing()) {
                return window;
            }
        }
        return null;
    }

    private static Component find(Container parent, String name) {
        Component found = search(parent, name);
        return Objects.requireNonNull(found, name);
    }

    private static @Nullable Component search(Container parent, String name) {
        for (Component child : parent.getComponents()) {
            Component found = name.equals(child.getName())
                    ? child
                    : child instanceof Container inner ? search(inner, name) : null;
            if (found != null) {
                return found;
            }
        }
        return null;
    }
}
