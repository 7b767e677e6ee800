package majic.gui;

import java.awt.event.KeyEvent;
import javax.swing.KeyStroke;
import majic.gui.kit.IconAction;
import majic.gui.kit.Pictogram;
import majic.text.Texts;

/** Holds the actions of the window's buttons, which are in the menus too. */
final class FrameActions {
    private static final Texts TEXTS = Texts.of(FrameActions.class);

    final IconAction addBot;
    final IconAction killBot;
    final IconAction loadAct;
    final IconAction help;
    final IconAction saveSession;
    final IconAction saveLog;
    final IconAction killMajic;

    FrameActions(FrameDialogs dialogs, FrameEditor editor, Runnable quit) {
        addBot = action("addBot", Pictogram.ADD, "addBot.tip", dialogs::addBot)
                .withKey(KeyEvent.VK_N)
                .openingDialog();
        killBot = action("killBot", Pictogram.REMOVE, "killBot.tip", dialogs::removeBot)
                .openingDialog();
        loadAct = action("loadAct", Pictogram.ACT, "loadAct.tip", dialogs::loadAct)
                .withKey(KeyEvent.VK_L)
                .openingDialog();
        help = action("help", Pictogram.HELP, "help.tip", dialogs::help)
                .withKey(KeyStroke.getKeyStroke(KeyEvent.VK_F1, 0));
        saveSession = action(
                        "saveSession", Pictogram.SESSION, "saveSession.tip", () -> dialogs.saveSession(editor::open))
                .withKey(KeyEvent.VK_S)
                .openingDialog();
        saveLog = action("saveLog", Pictogram.LOG, "saveLog.tip", dialogs::saveLog)
                .openingDialog();
        killMajic = action("killMajic", Pictogram.QUIT, "killMajic.tip", quit).withKey(KeyEvent.VK_Q);
    }

    private static IconAction action(String name, Pictogram icon, String tip, Runnable action) {
        return new IconAction(TEXTS.get(name), icon, TEXTS.get(tip), action);
    }

    /** Holds the actions that are in the menus alone. Made with the entries of the menus, after the first painting. */
    static final class MenuActions {
        final IconAction endAct;
        final IconAction makeAct;
        final IconAction guide;
        final IconAction about;
        final IconAction newScript;
        final IconAction openScript;
        final IconAction openRecording;
        final IconAction openTeam;
        final IconAction saveTeam;
        final IconAction shareRobots;
        final IconAction driveByKeys;
        final IconAction tour;

        MenuActions(FrameDialogs dialogs, FrameEditor editor, FrameTeams teams, Runnable driveByKeys) {
            endAct = action("endAct", Pictogram.REMOVE, "endAct.tip", dialogs::endAct)
                    .withKey(KeyEvent.VK_E);
            makeAct = action("makeAct", Pictogram.ACT, "makeAct.tip", dialogs::makeAct)
                    .openingDialog();
            guide = action("guide", Pictogram.HELP, "guide.tip", dialogs::guide);
            about = action("about", Pictogram.HELP, "about.tip", dialogs::about);
            newScript = action("newScript", Pictogram.NEW, "newScript.tip", () -> editor.newScript(""));
            openScript = action("openScript", Pictogram.OPEN, "openScript.tip", editor::chooseAndOpen)
                    .withKey(KeyEvent.VK_O)
                    .openingDialog();
            openRecording = action("openRecording", Pictogram.LOG, "openRecording.tip", dialogs::openRecording)
                    .openingDialog();
            openTeam = action("openTeam", Pictogram.TEAM, "openTeam.tip", teams::chooseAndOpen)
                    .openingDialog();
            saveTeam = action("saveTeam", Pictogram.TEAM, "saveTeam.tip", dialogs::saveTeam)
                    .openingDialog();
            shareRobots = action("shareRobots", Pictogram.TEAM, "shareRobots.tip", dialogs::shareRobots)
                    .openingDialog();
            shareRobots.setEnabled(dialogs.canShareRobots());
            this.driveByKeys = action("driveByKeys", Pictogram.DRIVE, "driveByKeys.tip", driveByKeys)
                    .withKey(KeyEvent.VK_D);
            tour = action("tour", Pictogram.TOUR, "tour.tip", dialogs::tour);
        }
    }
}
