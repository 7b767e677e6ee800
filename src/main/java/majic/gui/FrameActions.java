package majic.gui;

import java.awt.event.KeyEvent;
import java.util.List;
import javax.swing.KeyStroke;
import majic.gui.kit.IconAction;

/** Holds the actions of the window's buttons and menus. */
final class FrameActions {
    final IconAction addBot;
    final IconAction killBot;
    final IconAction loadAct;
    final IconAction endAct;
    final IconAction makeAct;
    final IconAction help;
    final IconAction guide;
    final IconAction about;
    final IconAction newScript;
    final IconAction openScript;
    final IconAction saveSession;
    final IconAction saveLog;
    final IconAction openRecording;
    final IconAction openTeam;
    final IconAction saveTeam;
    final IconAction tour;
    final IconAction killMajic;

    FrameActions(MajicFrame frame, FrameDialogs dialogs, FrameEditor editor) {
        addBot = new IconAction("Add Bot", "add", "Connect a robot", frame::addBot).withKey(KeyEvent.VK_N);
        killBot = new IconAction(
                "Kill Bot", "kill", "Stop a robot, close its connection and remove it", frame::removeBot);
        loadAct = new IconAction("Load Act", "act", "Load an act onto a robot", frame::loadAct).withKey(KeyEvent.VK_L);
        endAct = new IconAction("End Act", "kill", "End the act of the selected robots", frame::endAct)
                .withKey(KeyEvent.VK_E);
        makeAct = new IconAction("Make Act…", "act", "Make the file of an act from Java or a script", dialogs::makeAct);
        help = new IconAction("Help", "help", "Show commands, parameters and keys", dialogs::help)
                .withKey(KeyStroke.getKeyStroke(KeyEvent.VK_F1, 0));
        guide = new IconAction("Guide", "help", "Show the user's guide", dialogs::guide);
        about = new IconAction("About MAJIC", "app", "Show version and licences", dialogs::about);
        newScript = new IconAction("New Script", "new", "Write a script in the editor", editor::newScript);
        openScript = new IconAction(
                        "Open…", "open", "Open a script or a saved session in the editor", editor::chooseAndOpen)
                .withKey(KeyEvent.VK_O);
        saveSession = new IconAction(
                        "Save Session",
                        "session",
                        "Save the session as a script",
                        () -> dialogs.saveSession(editor::open))
                .withKey(KeyEvent.VK_S);
        saveLog = new IconAction("Save Log", "log", "Save the parameter log", dialogs::saveLog);
        openRecording =
                new IconAction("Open Recording…", "log", "Replay what robots reported earlier", dialogs::openRecording);
        openTeam = new IconAction("Open Team…", "team", "Add the robots of a saved team", frame::openTeam);
        saveTeam = new IconAction(
                "Save Team…", "team", "Save the robots with calibrations and start poses", dialogs::saveTeam);
        tour = new IconAction("Tour", "tour", "Five minutes with the robots of the lab", dialogs::tour);
        killMajic = new IconAction("Kill Majic", "quit", "Stop and close all robots and quit", frame::quit)
                .withKey(KeyEvent.VK_Q);
    }

    /** Returns the actions of the buttons, in the order of the buttons. */
    List<IconAction> buttons() {
        return List.of(addBot, killBot, loadAct, help, saveSession, saveLog, killMajic);
    }
}
