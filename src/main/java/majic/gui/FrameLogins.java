package majic.gui;

import java.awt.Window;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Set;
import majic.gui.kit.CommandChannel;
import majic.gui.kit.EventThread;
import majic.gui.kit.LoginDialog;
import majic.gui.kit.RobotSharing;
import majic.log.Line;
import majic.log.SessionListener;
import majic.script.MajicParser;

/**
 * Asks for the user name and the password of a broker that refuses those it was given, once for all robots that are
 * added meanwhile, and adds these robots again.
 */
final class FrameLogins implements SessionListener {
    private final Window owner;
    private final RobotSharing sharing;
    private final MajicParser parser;
    private final CommandChannel channel;
    private final Map<String, Set<String>> refused = new HashMap<>();

    FrameLogins(Window owner, RobotSharing sharing, MajicParser parser, CommandChannel channel) {
        this.parser = parser;
        this.owner = owner;
        this.sharing = sharing;
        this.channel = channel;
    }

    @Override
    public void line(Line line) {}

    @Override
    public void loginRefused(String address, String again) {
        EventThread.later(() -> ask(address, again));
    }

    private void ask(String address, String again) {
        String broker = LoginDialog.nameOf(address);
        Set<String> lines = refused.computeIfAbsent(broker, name -> new LinkedHashSet<>());
        if (LoginDialog.find(owner, address).isEmpty()) {
            lines.clear();
        }
        lines.add(again);
        LoginDialog.ask(owner, address, sharing, () -> channel.submit(String.join("\n", lines)), this::stops);
    }

    /** Executes a stop that was typed while the dialog opened. */
    private boolean stops(String typed) {
        boolean isStop = parser.isStop(typed);
        if (isStop) {
            channel.submit(typed);
        }
        return isStop;
    }
}
