package majic.pictures;

import static majic.pictures.PictureWindow.awaitWindow;
import static majic.pictures.PictureWindow.find;
import static majic.pictures.PictureWindow.select;

import com.formdev.flatlaf.FlatDarkLaf;
import com.formdev.flatlaf.FlatLaf;
import com.formdev.flatlaf.FlatLightLaf;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import javax.swing.JFrame;
import javax.swing.JSlider;
import javax.swing.JTabbedPane;
import javax.swing.SwingUtilities;
import majic.bot.MajicBot;
import majic.gui.MajicFrame;
import majic.gui.kit.RobotSharing.Place;
import majic.gui.kit.StopButton;
import majic.gui.replay.ReplayServices;
import majic.gui.replay.ReplayWindow;
import majic.pictures.PictureWindow.Settled;
import majic.program.Program;
import majic.program.UserFolder;
import majic.program.WindowPicture;
import majic.script.MajicParser;
import majic.shared.broker.Mosquitto;
import majic.simulation.SimulatedLab;
import majic.team.Member;
import majicsim.LabOptions;
import majicsim.LabPorts;
import majicsim.ros.options.RosOptions;
import org.junit.jupiter.api.Assertions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * Makes pictures of the window with each robot in each state and with each dialog, light and dark, to look at:
 * {@code mvn -Pstates test}, on a machine with a display. {@code -Dmajic.language=de} sets the language,
 * {@code -Dmajic.scale=1.5} the scale: as on X11, whole numbers are Java's own scale, others that of the look and feel.
 * Other scales than 1 need a display as much larger than 1280 × 800. If Mosquitto is installed, one of the robots is
 * that of another desk. {@code -Dstates="2-act plot"} makes only the pictures with one of these words in their names,
 * and {@code -Dmajic.states} names the folder in {@code target}.
 */
class StatePictures {
    private static final Path FOLDER =
            Path.of(System.getProperty("majic.target", "target"), System.getProperty("majic.states", "states"));
    /** Parts of the names of the pictures to make; the empty one is part of all. */
    private static final List<String> WANTED =
            List.of(System.getProperty("states", "").split("[ ,]+"));

    private static final double SCALE = Double.parseDouble(System.getProperty("majic.scale", "1"));
    /** Pixels of a picture for one of the window. */
    private static final double PICTURE_SCALE = SCALE == Math.rint(SCALE) ? SCALE : 1;

    private static final LabOptions OPTIONS =
            LabOptions.standard().withPorts(LabPorts.FREE).withNoise(7).withRos(RosOptions.parse("2+camera"));
    private static final List<String> ROBOTS = List.of("aibo", "pioneer", "hemisson", "ros");
    /** The one after those of the lab. */
    private static final int SHARED = ROBOTS.size() + 1;

    private static final double LOW_CHARGE = 0.12;
    private static final double OUTAGE_S = 600;

    static {
        System.setProperty("sun.java2d.uiScale", String.valueOf(PICTURE_SCALE));
        if (PICTURE_SCALE != SCALE) {
            System.setProperty("flatlaf.uiScale", String.valueOf(SCALE));
        }
        Locale.setDefault(Locale.forLanguageTag(System.getProperty("majic.language", "en")));
    }

    @Test
    @Timeout(600)
    void paintsEachStateOfEachRobot(@TempDir Path home) throws Exception {
        SimulatedLab lab = SimulatedLab.scaled(OPTIONS, 1);
        try (Program program = new Program(new UserFolder(home), lab, true)) {
            MajicParser parser = MajicParser.prompt(program.session());
            PictureWindow.decorate();
            MajicFrame frame = PictureWindow.open(program, parser);
            paint(frame, "start");
            PictureWindow.add(program, parser, ROBOTS);
            new DialogPictures(program, frame, StatePictures::paint).paint();
            paintRobots(frame, "connected");
            paintLayouts(frame);
            paintShared(program, parser, frame, home);
            paintTools(program, parser, frame, home);
            paintMotion(program, parser, frame);
            paintTrouble(lab, frame);
            paintLoss(program, lab, frame);
            replay(program, frame);
            SwingUtilities.invokeAndWait(frame::dispose);
        }
    }

    /** Paints two robots side by side, a panel in a window of its own, and the window at its smallest. */
    private static void paintLayouts(MajicFrame frame) throws Exception {
        if (!isWanted("layout")) {
            return;
        }
        new LayoutPictures(frame, StatePictures::paint).paint();
    }

    private static void paintTools(Program program, MajicParser parser, MajicFrame frame, Path home) throws Exception {
        ToolPictures tools = new ToolPictures(program, frame, StatePictures::paint);
        if (isWanted("plot")) {
            tools.paintPlot(parser, 2);
        }
        if (isWanted("editor")) {
            tools.paintEditor(home.resolve("lap.majic"));
        }
        if (isWanted("values")) {
            tools.paintValues(home.resolve("corners.majic"));
        }
        if (isWanted("question")) {
            tools.paintQuestions(parser);
        }
    }

    /** Paints the robots while they move, while acts run, and after STOP. */
    private static void paintMotion(Program program, MajicParser parser, MajicFrame frame) throws Exception {
        if (isWanted("moving")) {
            move(program, parser);
            paintRobots(frame, "moving");
            awaitIdle(program);
        }
        if (isWanted("act") || isWanted("stopped")) {
            List.of("1 act HeadScan", "2 act PioneerWander", "3 act LightSeek", "4 act WallFollow")
                    .forEach(parser::parseText);
            awaitWindow(() -> program.team().members().stream().noneMatch(Member::isIdle));
            paintRobots(frame, "act");
            parser.parseText("stop");
            awaitWindow(() -> find(frame, "release").isVisible());
            paintRobots(frame, "stopped");
            parser.parseText("release");
        }
    }

    private static void paintTrouble(SimulatedLab lab, MajicFrame frame) throws Exception {
        lab.simulators().besideAibo(aibo -> aibo.changeBattery(LOW_CHARGE));
        lab.simulators().besidePioneer(pioneer -> pioneer.pressStop(true));
        lab.simulators().besideHemisson(hemisson -> hemisson.moveSwitches("1110"));
        paintRobots(frame, "trouble");
    }

    private static void paintLoss(Program program, SimulatedLab lab, MajicFrame frame) throws Exception {
        if (isWanted("lost") || isWanted("reconnecting")) {
            lose(program, lab);
            paintRobots(frame, "lost");
            awaitWindow(() -> program.team().members().stream()
                    .anyMatch(member -> member.bot().connection() == MajicBot.Connection.CONNECTING));
            paintRobots(frame, "reconnecting");
        }
    }

    /** Adds a robot that another desk shares, in the states that no other robot has, and removes it. */
    private static void paintShared(Program program, MajicParser parser, MajicFrame frame, Path home) throws Exception {
        boolean wanted = isWanted(SHARED + "-shared-moving") || isWanted(SHARED + "-shared-lost");
        if (Mosquitto.installed().isEmpty() || !wanted) {
            return;
        }
        try (Mosquitto broker = Mosquitto.start(home);
                Program desk =
                        new Program(new UserFolder(home.resolve("desk")), SimulatedLab.scaled(OPTIONS, 1), true)) {
            MajicParser atDesk = MajicParser.prompt(desk.session());
            PictureWindow.add(desk, atDesk, List.of("pioneer"));
            String site = "mqtt://127.0.0.1:" + broker.port() + "/lab";
            desk.sharing().start(new Place(site, "desk2", "Bert"));
            parser.parseText("add " + site + "/desk2/1 as " + SHARED);
            awaitWindow(() -> PictureWindow.isShowing(frame, "tab" + SHARED));
            select(frame, SHARED);
            paint(frame, SHARED + "-shared");
            parser.parseText(SHARED + " drive 100 20 for 60s");
            paint(frame, SHARED + "-shared-moving");
            parser.parseText(SHARED + " stop");
            desk.sharing().stop();
            paint(frame, SHARED + "-shared-lost");
            parser.parseText("remove " + SHARED);
            awaitWindow(() -> program.team().members().size() < SHARED);
        }
    }

    private static void move(Program program, MajicParser parser) {
        List.of("1 move 400", "2 move 900", "3 move 200", "4 move 300").forEach(parser::parseText);
        awaitIdle(program);
        List.of("1 drive 60 10 for 20s", "2 drive 150 20 for 20s", "3 drive 20 20 for 20s", "4 drive 100 20 for 20s")
                .forEach(parser::parseText);
    }

    private static void awaitIdle(Program program) {
        awaitWindow(() -> program.team().members().stream().allMatch(Member::isIdle));
    }

    /** Cuts all connections; new ones get no answer. */
    private static void lose(Program program, SimulatedLab lab) {
        for (String robot : ROBOTS) {
            lab.simulators().faults(robot).outage(OUTAGE_S);
            lab.simulators().faults(robot).cut();
        }
        awaitWindow(() -> program.team().members().stream()
                .noneMatch(member -> member.bot().isConnected()));
    }

    private static void replay(Program program, MajicFrame frame) throws Exception {
        if (!isWanted("replay")) {
            return;
        }
        Path file = program.recordings().files().get(0);
        ReplayServices services = new ReplayServices(
                program.settings(),
                program.session().factory().types(),
                () -> new StopButton(program.team(), program.team()::stopAllIfAny));
        SwingUtilities.invokeAndWait(() -> ReplayWindow.open(frame, file, services, () -> {}, Assertions::fail));
        awaitWindow(() -> PictureWindow.replay() != null);
        JFrame replay = Objects.requireNonNull(PictureWindow.replay());
        JSlider timeline = (JSlider) find(replay, "timeline");
        SwingUtilities.invokeAndWait(() -> timeline.setValue(timeline.getMaximum() / 3));
        for (int robot = 1; robot <= ROBOTS.size(); robot++) {
            int tab = robot - 1;
            SwingUtilities.invokeAndWait(() -> ((JTabbedPane) find(replay, "replayRobots")).setSelectedIndex(tab));
            paint(replay, robot + "-replay");
        }
        SwingUtilities.invokeAndWait(replay::dispose);
    }

    private static void paintRobots(MajicFrame frame, String state) throws Exception {
        for (int robot = 1; robot <= ROBOTS.size(); robot++) {
            if (isPainted(robot + "-" + state)) {
                select(frame, robot);
                paint(frame, robot + "-" + state);
            }
        }
    }

    /** Returns whether a picture with this name is to be made. */
    private static boolean isPainted(String name) {
        return WANTED.stream().anyMatch(name::contains);
    }

    /** Returns whether a picture is to be made whose name contains a word, or is a part of it. */
    private static boolean isWanted(String part) {
        return WANTED.stream().anyMatch(word -> word.contains(part) || part.contains(word));
    }

    /** Paints a window in the light and in the dark look. */
    private static void paint(JFrame window, String name) throws Exception {
        if (!isPainted(name)) {
            return;
        }
        awaitWindow(new Settled());
        WindowPicture.save(window, FOLDER.resolve(name + "-light.png"), PICTURE_SCALE);
        look(new FlatDarkLaf());
        if (!(window instanceof MajicFrame)) {
            awaitWindow(new Settled()); // charts are painted anew on a thread of their own
        }
        WindowPicture.save(window, FOLDER.resolve(name + "-dark.png"), PICTURE_SCALE);
        look(new FlatLightLaf());
    }

    private static void look(FlatLaf look) throws Exception {
        SwingUtilities.invokeAndWait(() -> {
            FlatLaf.setup(look);
            FlatLaf.updateUI();
        });
        SwingUtilities.invokeAndWait(() -> {});
    }
}
