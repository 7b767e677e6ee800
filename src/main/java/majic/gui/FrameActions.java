package majic.gui;

import java.awt.event.KeyEvent;
import java.util.List;
import majic.gui.kit.IconAction;

/** Holds the actions of the window's buttons and menus. */
final class FrameActions {
    final IconAction addBot;
    final IconAction killBot;
    final IconAction loadAct;
    final IconAction endAct;
    final IconAction makeAct;
    final IconAction help;
    final IconAction saveSession;
    final IconAction saveLog;
    final IconAction killMajic;

    FrameActions(MajicFrame frame, FrameDialogs dialogs) {
        addBot = new IconAction("Add Bot", "add", "Connect a robot", frame::addBot).withKey(KeyEvent.VK_N);
        killBot = new IconAction("Kill Bot", "kill", "Stop a robot and let it go", frame::removeBot);
        loadAct = new IconAction("Load Act", "act", "Give a robot a behaviour", frame::loadAct).withKey(KeyEvent.VK_L);
        endAct = new IconAction(
                        "End Act", "kill", "End the behaviour of the robot whose tab is in front", frame::endAct)
                .withKey(KeyEvent.VK_E);
        makeAct = new IconAction("Make Act…", "act", "Make a behaviour's file of Java or a script", dialogs::makeAct);
        help = new IconAction("Help", "help", "Commands, parameters and keys", dialogs::help);
        saveSession = new IconAction("Save Session", "session", "Save what was done as a script", dialogs::saveSession)
                .withKey(KeyEvent.VK_S);
        saveLog = new IconAction("Save Log", "log", "Save the parameters logged so far", dialogs::saveLog);
        killMajic = new IconAction("Kill Majic", "quit", "Stop and close all robots and end", frame::quit)
                .withKey(KeyEvent.VK_Q);
    }

    /** Returns the actions of the buttons, in the order of the buttons. */
    List<IconAction> buttons() {
        return List.of(addBot, killBot, loadAct, help, saveSession, saveLog, killMajic);
    }
}
