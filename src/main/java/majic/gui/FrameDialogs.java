package majic.gui;

import java.awt.Window;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;
import java.util.stream.Stream;
import majic.gui.acts.ActLoader;
import majic.gui.acts.LoadActDialog;
import majic.gui.acts.MakeActDialog;
import majic.gui.add.AddBotDialog;
import majic.gui.bots.KillBotDialog;
import majic.gui.help.AboutDialog;
import majic.gui.help.HelpDialog;
import majic.gui.kit.ChooseFile;
import majic.gui.kit.CommandChannel;
import majic.gui.kit.MajicDialog;
import majic.gui.kit.PictureDialog;
import majic.gui.kit.ProgramServices;
import majic.gui.kit.RobotSelection;
import majic.gui.replay.RecordingsDialog;
import majic.gui.replay.ReplayServices;
import majic.gui.start.Tour;
import majic.panel.PictureView;
import majic.script.Session;
import majic.team.Member;

/** Opens the window's dialogs; creates each at its first use and never shows one of them twice at a time. */
final class FrameDialogs {
    private static final String KILL_BOT = "Kill Bot";
    private static final String LOAD_ACT = "Load Act";

    private final MajicFrame frame;
    private final Session session;
    private final ProgramServices services;
    private final RobotSelection selection;
    private final ActLoader loader;

    FrameDialogs(
            MajicFrame frame,
            Session session,
            ProgramServices services,
            RobotSelection selection,
            CommandChannel channel) {
        this.frame = frame;
        this.session = session;
        this.services = services;
        this.selection = selection;
        this.loader = new ActLoader(frame, session, channel, services.settings());
    }

    void addBot() {
        open("Add Bot", () -> new AddBotDialog(frame, session, services, selection::select, AddBotDialog.GIVE_UP_MS));
    }

    void removeBot() {
        withRobots(members -> removeBot(selection.first()));
    }

    /** Opens the dialog that removes a robot, with this one chosen; one that is open for another robot is closed. */
    void removeBot(Member member) {
        close(KILL_BOT);
        removeBot(Optional.of(member));
    }

    private void removeBot(Optional<Member> chosen) {
        Consumer<Member> kill = member -> frame.submit("remove " + member.number());
        open(KILL_BOT, () -> new KillBotDialog(frame, session.team().members(), chosen, kill));
    }

    void loadAct() {
        withRobots(members -> loadAct(selection.members()));
    }

    /** Opens the dialogs that load an act, with this robot chosen; one that is open for another robot is closed. */
    void loadAct(Member member) {
        close(LOAD_ACT);
        loadAct(List.of(member));
    }

    private void loadAct(List<Member> chosen) {
        open(LOAD_ACT, () -> new LoadActDialog(frame, session.team().members(), chosen, loader::load));
    }

    void makeAct() {
        open("Make Act", () -> new MakeActDialog(frame, session.offers(), services.settings()));
    }

    /** Opens the dialog that makes the file of an act, for a script. */
    void makeActOf(Path script) {
        makeAct();
        shown("Make Act").ifPresent(dialog -> ((MakeActDialog) dialog).makeOf(script));
    }

    void help() {
        open("Help", this::newHelp);
    }

    /** Shows the guide, in the help if that is open already. */
    void guide() {
        open("Help", this::newHelp);
        Stream.of(frame.getOwnedWindows())
                .filter(window -> window.isShowing() && window instanceof HelpDialog)
                .forEach(window -> ((HelpDialog) window).showGuide());
    }

    private HelpDialog newHelp() {
        return new HelpDialog(frame, session.team().members(), selection.first());
    }

    void about() {
        open("About MAJIC", () -> new AboutDialog(frame));
    }

    void picture(PictureView view) {
        open(view.title(), () -> new PictureDialog(frame, view, services.settings()));
    }

    void saveTeam() {
        save("Save Team", "lab.team", "save team ");
    }

    void tour() {
        open("Tour", () -> new Tour(frame, session));
    }

    /**
     * Asks where to save the session.
     *
     * @param edit opens a script in the editor
     */
    void saveSession(Consumer<Path> edit) {
        ChooseFile.toSave(
                frame,
                services.settings(),
                "Save Session",
                "session.majic",
                file -> save("save session ", file),
                new ChooseFile.Offer("Open it in the script editor", edit));
    }

    void saveLog() {
        save("Save Log", "log.csv", "save log ");
    }

    void openRecording() {
        open("Open Recording", () -> new RecordingsDialog(frame, services.recordings(), replays()));
    }

    private ReplayServices replays() {
        return new ReplayServices(services.settings(), session.factory().types(), frame::stopButton);
    }

    private void save(String title, String suggestion, String command) {
        ChooseFile.toSave(frame, services.settings(), title, suggestion, file -> save(command, file));
    }

    /**
     * Runs a command with a file name, unless the name has a quotation mark, which the script language cannot write.
     * Blocks until the command has ended.
     *
     * @return why it failed; empty if it did not
     */
    private Optional<String> save(String command, Path file) {
        if (file.toString().contains("\"")) {
            return Optional.of(file + ": a file whose name has a quotation mark in it cannot be used here");
        }
        return AwaitedLine.run(session, command + '"' + file + '"');
    }

    private void withRobots(Consumer<List<Member>> action) {
        List<Member> members = session.team().members();
        if (members.isEmpty()) {
            frame.showError("There are no robots yet; Add Bot connects one.");
        } else {
            action.accept(members);
        }
    }

    private void open(String title, Supplier<MajicDialog> make) {
        shown(title).ifPresentOrElse(Window::toFront, () -> make.get().setVisible(true));
    }

    private Optional<Window> shown(String title) {
        return Stream.of(frame.getOwnedWindows())
                .filter(window -> window instanceof MajicDialog dialog
                        && dialog.isShowing()
                        && dialog.getTitle().equals(title))
                .findFirst();
    }

    private void close(String title) {
        shown(title).ifPresent(Window::dispose);
    }
}
