package majic.gui;

import java.awt.Window;
import java.nio.file.Path;
import javax.swing.filechooser.FileFilter;
import javax.swing.filechooser.FileNameExtensionFilter;
import majic.gui.kit.ChooseFile;
import majic.gui.kit.CommandChannel;
import majic.gui.kit.EventThreadTeamListener;
import majic.gui.kit.ProgramServices;
import majic.gui.start.LastTeam;
import majic.gui.start.TeamOpener;
import majic.script.Session;
import majic.text.Texts;

/** Opens saved teams and the team of the last session, and keeps the present one. */
final class FrameTeams {
    private static final Texts TEXTS = Texts.of(FrameTeams.class);

    private final Window owner;
    private final ProgramServices services;
    private final LastTeam last;
    private final TeamOpener opener;

    FrameTeams(Window owner, Session session, ProgramServices services, CommandChannel channel) {
        this.owner = owner;
        this.services = services;
        this.last = new LastTeam(session, services.settings());
        this.opener = new TeamOpener(session, services, channel);
        session.team().addListener(new EventThreadTeamListener(last));
    }

    LastTeam last() {
        return last;
    }

    void openLast() {
        opener.open(last);
    }

    /** Asks for the file of a team, and opens it. */
    void chooseAndOpen() {
        FileFilter files = new FileNameExtensionFilter(TEXTS.get("teamFiles"), "team");
        ChooseFile.toOpen(owner, services.settings(), TEXTS.get("openTeam"), files, this::open);
    }

    /** Connects the robots of a saved team. */
    void open(Path file) {
        opener.open(file);
    }
}
