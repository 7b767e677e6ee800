package majic.gui;

import java.awt.event.KeyEvent;
import java.util.List;
import javax.swing.KeyStroke;
import majic.gui.kit.IconAction;
import majic.text.Texts;

/** Holds the actions of the window's buttons and menus. */
final class FrameActions {
    private static final Texts TEXTS = Texts.of(FrameActions.class);

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
        addBot = action("addBot", "add", "addBot.tip", frame::addBot).withKey(KeyEvent.VK_N);
        killBot = action("killBot", "kill", "killBot.tip", frame::removeBot);
        loadAct = action("loadAct", "act", "loadAct.tip", frame::loadAct).withKey(KeyEvent.VK_L);
        endAct = action("endAct", "kill", "endAct.tip", dialogs::endAct).withKey(KeyEvent.VK_E);
        makeAct = action("makeAct", "act", "makeAct.tip", dialogs::makeAct);
        help = action("help", "help", "help.tip", dialogs::help).withKey(KeyStroke.getKeyStroke(KeyEvent.VK_F1, 0));
        guide = action("guide", "help", "guide.tip", dialogs::guide);
        about = action("about", "app", "about.tip", dialogs::about);
        newScript = action("newScript", "new", "newScript.tip", editor::newScript);
        openScript = action("openScript", "open", "openScript.tip", editor::chooseAndOpen)
                .withKey(KeyEvent.VK_O);
        saveSession = action("saveSession", "session", "saveSession.tip", () -> dialogs.saveSession(editor::open))
                .withKey(KeyEvent.VK_S);
        saveLog = action("saveLog", "log", "saveLog.tip", dialogs::saveLog);
        openRecording = action("openRecording", "log", "openRecording.tip", dialogs::openRecording);
        openTeam = action("openTeam", "team", "openTeam.tip", frame::openTeam);
        saveTeam = action("saveTeam", "team", "saveTeam.tip", dialogs::saveTeam);
        tour = action("tour", "tour", "tour.tip", dialogs::tour);
        killMajic = action("killMajic", "quit", "killMajic.tip", frame::quit).withKey(KeyEvent.VK_Q);
    }

    private static IconAction action(String name, String icon, String tip, Runnable action) {
        return new IconAction(TEXTS.get(name), icon, TEXTS.get(tip), action);
    }

    /** Returns the actions of the buttons, in the order of the buttons. */
    List<IconAction> buttons() {
        return List.of(addBot, killBot, loadAct, help, saveSession, saveLog, killMajic);
    }
}
