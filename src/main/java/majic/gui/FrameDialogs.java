package majic.gui;

import java.awt.Window;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.Supplier;
import java.util.stream.Stream;
import majic.gui.acts.ActLoader;
import majic.gui.acts.LoadActDialog;
import majic.gui.acts.MakeActDialog;
import majic.gui.add.AddBotDialog;
import majic.gui.bots.BotTabs;
import majic.gui.bots.KillBotDialog;
import majic.gui.kit.ChooseFile;
import majic.gui.kit.CommandChannel;
import majic.gui.kit.MajicDialog;
import majic.gui.kit.ProgramServices;
import majic.script.Session;
import majic.team.Member;

/** Opens the window's dialogs; creates each at its first use and never shows one of them twice at a time. */
final class FrameDialogs {
    private final MajicFrame frame;
    private final Session session;
    private final ProgramServices services;
    private final BotTabs tabs;
    private final ActLoader loader;

    FrameDialogs(MajicFrame frame, Session session, ProgramServices services, BotTabs tabs, CommandChannel channel) {
        this.frame = frame;
        this.session = session;
        this.services = services;
        this.tabs = tabs;
        this.loader = new ActLoader(frame, session, channel);
    }

    void addBot() {
        open("Add Bot", () -> new AddBotDialog(frame, session, services, tabs::select, AddBotDialog.GIVE_UP_MS));
    }

    void removeBot() {
        Consumer<Member> kill = member -> frame.submit("remove " + member.number());
        withRobots(members -> open("Kill Bot", () -> new KillBotDialog(frame, members, tabs.selected(), kill)));
    }

    void loadAct() {
        withRobots(members -> open("Load Act", () -> new LoadActDialog(frame, members, tabs.selected(), loader::load)));
    }

    void makeAct() {
        open("Make Act", () -> new MakeActDialog(frame, session.offers()));
    }

    void help() {
        open("Help", () -> new HelpDialog(frame, session.team().members(), tabs.selected()));
    }

    void saveSession() {
        ChooseFile.toSave(frame, "Save Session", "session.majic", file -> submit("save session ", file));
    }

    void saveLog() {
        ChooseFile.toSave(frame, "Save Log", "log.csv", file -> submit("save log ", file));
    }

    /**
     * Submits a command with a file name, unless the name has a quotation mark, which the script language cannot write.
     */
    private void submit(String command, Path file) {
        if (file.toString().contains("\"")) {
            frame.showError(file + ": a file whose name has a quotation mark in it cannot be used here");
        } else {
            frame.submit(command + '"' + file + '"');
        }
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
        Stream.of(frame.getOwnedWindows())
                .filter(window -> window instanceof MajicDialog dialog
                        && dialog.isShowing()
                        && dialog.getTitle().equals(title))
                .findFirst()
                .ifPresentOrElse(Window::toFront, () -> make.get().setVisible(true));
    }
}
