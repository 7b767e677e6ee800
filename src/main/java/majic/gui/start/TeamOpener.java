package majic.gui.start;

import java.nio.file.Path;
import java.util.function.Supplier;
import majic.gui.kit.CommandChannel;
import majic.gui.kit.EventThread;
import majic.gui.kit.ProgramServices;
import majic.script.SavedTeam;
import majic.script.Session;

/** Opens saved teams; starts the simulated lab first if a robot of it is in the team. Returns at once. */
public final class TeamOpener {
    private final Session session;
    private final ProgramServices services;
    private final CommandChannel channel;

    /**
     * Creates an opener.
     *
     * @param channel shows why a team cannot be opened
     */
    public TeamOpener(Session session, ProgramServices services, CommandChannel channel) {
        this.session = session;
        this.services = services;
        this.channel = channel;
    }

    public void open(Path file) {
        open(() -> SavedTeam.read(file));
    }

    public void open(LastTeam last) {
        open(() -> last.saved().orElseThrow());
    }

    private void open(Supplier<SavedTeam> reading) {
        EventThread.background(
                "opening a team",
                () -> {
                    SavedTeam team = reading.get();
                    Runnable startLab = services.startLab();
                    if (team.needsLab() && session.factory().lab().isEmpty() && startLab != null) {
                        startLab.run();
                    }
                    team.open(session);
                },
                channel::showError);
    }
}
