package majic.gui;

import java.awt.event.KeyEvent;
import java.util.List;

/** Holds the actions of the window's buttons and menus. */
final class FrameActions {
    final FrameAction addBot;
    final FrameAction killBot;
    final FrameAction loadAct;
    final FrameAction endAct;
    final FrameAction makeAct;
    final FrameAction help;
    final FrameAction saveSession;
    final FrameAction saveLog;
    final FrameAction killMajic;

    FrameActions(MajicFrame frame, FrameDialogs dialogs) {
        addBot = new FrameAction("Add Bot", "add", "Connect a robot", frame::addBot).withKey(KeyEvent.VK_N);
        killBot = new FrameAction("Kill Bot", "kill", "Stop a robot and let it go", frame::removeBot);
        loadAct = new FrameAction("Load Act", "act", "Give a robot a behaviour", frame::loadAct).withKey(KeyEvent.VK_L);
        endAct = new FrameAction(
                        "End Act", "kill", "End the behaviour of the robot whose tab is in front", frame::endAct)
                .withKey(KeyEvent.VK_E);
        makeAct = new FrameAction("Make Act…", "act", "Make a behaviour's file of Java or a script", dialogs::makeAct);
        help = new FrameAction("Help", "help", "Commands, parameters and keys", dialogs::help);
        saveSession = new FrameAction("Save Session", "session", "Save what was done as a script", dialogs::saveSession)
                .withKey(KeyEvent.VK_S);
        saveLog = new FrameAction("Save Log", "log", "Save the parameters logged so far", dialogs::saveLog);
        killMajic = new FrameAction("Kill Majic", "quit", "Stop and close all robots and end", frame::quit)
                .withKey(KeyEvent.VK_Q);
    }

    /** Returns the actions of the buttons, in the order of the buttons. */
    List<FrameAction> buttons() {
        return List.of(addBot, killBot, loadAct, help, saveSession, saveLog, killMajic);
    }
}
