package majic.gui;

import java.awt.Window;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;
import java.util.stream.Stream;
import javax.swing.JFrame;
import majic.gui.acts.ActLoader;
import majic.gui.acts.LoadActDialog;
import majic.gui.acts.LoadTargets;
import majic.gui.acts.MakeActDialog;
import majic.gui.add.AddBotDialog;
import majic.gui.bots.KillBotDialog;
import majic.gui.bots.ShareDialog;
import majic.gui.help.AboutDialog;
import majic.gui.help.HelpDialog;
import majic.gui.kit.BotStatus;
import majic.gui.kit.ChooseFile;
import majic.gui.kit.CommandChannel;
import majic.gui.kit.MajicDialog;
import majic.gui.kit.PictureDialog;
import majic.gui.kit.ProgramServices;
import majic.gui.kit.RobotSelection;
import majic.gui.kit.RobotSharing;
import majic.gui.kit.StopButton;
import majic.gui.replay.RecordingsDialog;
import majic.gui.replay.ReplayServices;
import majic.gui.replay.ReplayWindow;
import majic.gui.start.Tour;
import majic.panel.PictureView;
import majic.script.ActOffer;
import majic.script.Session;
import majic.team.Member;
import majic.text.Texts;

/**
 * Does what the buttons and menus offer: opens dialogs, each created at its first use and never shown twice at a time,
 * and ends acts.
 */
final class FrameDialogs {
    private static final Texts TEXTS = Texts.of(FrameDialogs.class);

    private final JFrame frame;
    private final Session session;
    private final ProgramServices services;
    private final RobotSelection selection;
    private final CommandChannel channel;
    private final Supplier<StopButton> stopButtons;
    private final ActLoader loader;

    /**
     * Dialogs that are not created yet.
     *
     * @param frame their owner
     * @param stopButtons makes the STOP button of a window beside the frame
     */
    FrameDialogs(
            JFrame frame,
            Session session,
            ProgramServices services,
            RobotSelection selection,
            CommandChannel channel,
            Supplier<StopButton> stopButtons) {
        this.frame = frame;
        this.session = session;
        this.services = services;
        this.selection = selection;
        this.channel = channel;
        this.stopButtons = stopButtons;
        this.loader = new ActLoader(frame, session, channel, services.settings());
    }

    void addBot() {
        AddBotDialog.inPieces(frame, session, services, selection::select, dialog -> open(AddBotDialog.class, dialog));
    }

    private AddBotDialog newAddBot() {
        return new AddBotDialog(frame, session, services, selection::select, AddBotDialog.GIVE_UP_MS);
    }

    void removeBot() {
        withRobots(members -> removeBot(selection.first()));
    }

    /** Opens the dialog that removes a robot, with this one chosen; one that is open for another robot is closed. */
    void removeBot(Member member) {
        close(KillBotDialog.class);
        removeBot(Optional.of(member));
    }

    private void removeBot(Optional<Member> chosen) {
        open(KillBotDialog.class, () -> newKillBot(chosen));
    }

    private KillBotDialog newKillBot(Optional<Member> chosen) {
        Consumer<Member> kill = member -> channel.submit("remove " + member.number());
        return new KillBotDialog(frame, session.team().members(), chosen, kill);
    }

    /** Returns whether the program can share robots. */
    boolean canShareRobots() {
        return services.sharing() != null;
    }

    void shareRobots() {
        RobotSharing sharing = services.sharing();
        if (sharing != null) {
            open(ShareDialog.class, () -> new ShareDialog(frame, sharing));
        }
    }

    void loadAct() {
        withRobots(members -> loadAct(selection.members()));
    }

    /** Opens the dialogs that load an act, with the act of a file selected; one that is open is closed. */
    void loadAct(Path file) {
        withRobots(members -> {
            close(LoadActDialog.class);
            newLoadAct(selection.members(), targets -> loader.load(targets, file))
                    .setVisible(true);
        });
    }

    /** Opens the dialogs that load an act, with this robot chosen; one that is open for another robot is closed. */
    void loadAct(Member member) {
        close(LoadActDialog.class);
        loadAct(List.of(member));
    }

    private void loadAct(List<Member> chosen) {
        open(LoadActDialog.class, () -> newLoadAct(chosen, loader::load));
    }

    private LoadActDialog newLoadAct(List<Member> chosen, Consumer<LoadTargets> load) {
        return new LoadActDialog(frame, session.team().members(), chosen, load);
    }

    /** Ends the acts of the selected robots; shows a message if no robot is selected. */
    void endAct() {
        withRobots(members -> {
            List<Member> selected = selection.members();
            List<Member> inAct = selected.stream().filter(BotStatus::isInAct).toList();
            List<Member> meant = inAct.isEmpty() ? selected : inAct;
            if (meant.isEmpty()) {
                channel.showError(TEXTS.get("noneSelected"));
            } else {
                channel.submit(
                        ActOffer.endLine(meant.stream().map(Member::number).toList()));
            }
        });
    }

    void makeAct() {
        open(MakeActDialog.class, this::newMakeAct);
    }

    private MakeActDialog newMakeAct() {
        return new MakeActDialog(frame, session.offers(), services.settings());
    }

    /** Opens the dialog that makes the file of an act, for a script. */
    void makeActOf(Path script) {
        makeAct();
        shown(MakeActDialog.class).forEach(dialog -> dialog.makeOf(script));
    }

    void help() {
        open(HelpDialog.class, this::newHelp);
    }

    /**
     * Shows the help, at a section of the guide if one is given.
     *
     * @param section as in {@link majic.gui.kit.HelpTopic}
     */
    void help(Optional<String> section) {
        help();
        section.ifPresent(heading -> shown(HelpDialog.class).forEach(dialog -> dialog.showSection(heading)));
    }

    /** Shows the guide, in the help if that is open already. */
    void guide() {
        open(HelpDialog.class, this::newHelp);
        shown(HelpDialog.class).forEach(HelpDialog::showGuide);
    }

    private HelpDialog newHelp() {
        return new HelpDialog(frame, session.team().members(), selection.first());
    }

    void about() {
        open(AboutDialog.class, () -> new AboutDialog(frame));
    }

    void picture(PictureView view) {
        toFrontOr(
                shown(PictureDialog.class).filter(dialog -> dialog.getTitle().equals(view.title())),
                () -> new PictureDialog(frame, view, services.settings()));
    }

    void saveTeam() {
        save(TEXTS.get("saveTeam"), "lab.team", "team");
    }

    void tour() {
        open(Tour.class, () -> new Tour(frame, session));
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
                TEXTS.get("saveSession"),
                "session.majic",
                file -> save("session", file),
                new ChooseFile.Offer(TEXTS.get("saveSession.edit"), edit));
    }

    void saveLog() {
        save(TEXTS.get("saveLog"), "log.csv", "log");
    }

    void openRecording() {
        open(RecordingsDialog.class, () -> new RecordingsDialog(frame, services.recordings(), replays()));
    }

    /** Opens the replay of a recording; shows a message if the file cannot be read. */
    void openRecording(Path file) {
        ReplayWindow.open(frame, file, replays(), () -> {}, channel::showError);
    }

    private ReplayServices replays() {
        return new ReplayServices(services.settings(), session.factory().types(), stopButtons);
    }

    private void save(String title, String suggestion, String what) {
        ChooseFile.toSave(frame, services.settings(), title, suggestion, file -> save(what, file));
    }

    /**
     * Runs a command with a file name, unless the name has a quotation mark, which the script language cannot write.
     * Blocks until the command has ended.
     *
     * @return why it failed; empty if it did not
     */
    private Optional<String> save(String what, Path file) {
        if (file.toString().contains("\"")) {
            return Optional.of(TEXTS.get("quotationMark", file));
        }
        return AwaitedLine.run(session, "save " + what + " \"" + file + '"');
    }

    /** Builds and paints the dialogs without showing them. */
    void rehearse() {
        List<MajicDialog> all = new ArrayList<>(List.of(newAddBot(), newMakeAct(), newHelp(), new AboutDialog(frame)));
        List<Member> members = session.team().members();
        if (!members.isEmpty()) {
            all.add(newKillBot(Optional.empty()));
            all.add(newLoadAct(members, loader::load));
        }
        all.forEach(dialog -> {
            MajicFrame.paintUnseen(dialog);
            dialog.dispose();
        });
    }

    private void withRobots(Consumer<List<Member>> action) {
        List<Member> members = session.team().members();
        if (members.isEmpty()) {
            channel.showError(TEXTS.get("noRobot"));
        } else {
            action.accept(members);
        }
    }

    private <D extends MajicDialog> void open(Class<D> kind, Supplier<D> make) {
        toFrontOr(shown(kind), make);
    }

    private static <D extends MajicDialog> void toFrontOr(Stream<D> shown, Supplier<D> make) {
        shown.findFirst().ifPresentOrElse(Window::toFront, () -> make.get().setVisible(true));
    }

    private <D extends MajicDialog> Stream<D> shown(Class<D> kind) {
        return Stream.of(frame.getOwnedWindows())
                .filter(Window::isShowing)
                .filter(kind::isInstance)
                .map(kind::cast);
    }

    private void close(Class<? extends MajicDialog> kind) {
        shown(kind).forEach(Window::dispose);
    }
}
