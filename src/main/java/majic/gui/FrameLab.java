package majic.gui;

import java.util.List;
import java.util.stream.Collectors;
import majic.bot.BotException;
import majic.gui.kit.CommandChannel;
import majic.gui.kit.EventThread;
import majic.gui.kit.ProgramServices;
import majic.lab.LabAccess;
import majic.script.Session;

/** Starts the simulated lab from the window. */
final class FrameLab {
    private final Session session;
    private final ProgramServices services;
    private final CommandChannel channel;

    FrameLab(Session session, ProgramServices services, CommandChannel channel) {
        this.session = session;
        this.services = services;
        this.channel = channel;
    }

    boolean isRunning() {
        return session.factory().lab().isPresent();
    }

    boolean canStart() {
        return services.startLab() != null && !isRunning();
    }

    /** Starts the lab and adds its robots, in the background. */
    void start() {
        Runnable start = services.startLab();
        if (start != null) {
            EventThread.background("starting the lab", () -> start(start));
        }
    }

    void showTruePositions() {
        channel.submit("lab");
    }

    private void start(Runnable start) {
        try {
            start.run();
            List<String> robots = session.factory().lab().map(LabAccess::robots).orElse(List.of());
            channel.submit(robots.stream().map(robot -> "add sim:" + robot).collect(Collectors.joining("\n")));
        } catch (BotException e) {
            channel.showError(e.getMessage());
        }
    }
}
