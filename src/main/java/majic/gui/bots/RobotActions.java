package majic.gui.bots;

import java.awt.Component;
import java.awt.KeyboardFocusManager;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import javax.swing.SwingUtilities;
import majic.bot.BotException;
import majic.bot.ConnectFailed;
import majic.gui.kit.CommandChannel;
import majic.gui.kit.Confirm;
import majic.gui.kit.EventThread;
import majic.gui.kit.StopButton;
import majic.gui.plot.Plots;
import majic.team.AutoReconnect;
import majic.team.Member;
import majic.team.Team;
import majic.text.ErrorWords;
import majic.text.Texts;

/** What the buttons and menus of a robot do. Must be used on the event dispatch thread; no method blocks. */
public final class RobotActions {
    private static final Texts TEXTS = Texts.of(RobotActions.class);

    private final Team team;
    private final CommandChannel channel;
    private final Plots plots;
    private final Consumer<Member> loadAct;
    private final Consumer<Member> kill;
    private final AutoReconnect attempts;
    private final Function<Member, Optional<String>> addresses;

    /**
     * Creates the actions.
     *
     * @param channel submits lines and shows messages
     * @param plots shows plots of what the robots report
     * @param loadAct opens the dialog that loads an act onto a robot
     * @param kill opens the dialog that removes a robot
     * @param attempts connects lost robots again
     * @param addresses returns where a robot was connected
     */
    public RobotActions(
            Team team,
            CommandChannel channel,
            Plots plots,
            Consumer<Member> loadAct,
            Consumer<Member> kill,
            AutoReconnect attempts,
            Function<Member, Optional<String>> addresses) {
        this.team = team;
        this.channel = channel;
        this.plots = plots;
        this.loadAct = loadAct;
        this.kill = kill;
        this.attempts = attempts;
        this.addresses = addresses;
    }

    /** Stops this robot alone, and whatever drives it. */
    void stop(Member member) {
        team.stop(List.of(member), null);
    }

    /** Makes the STOP button of a window beside the main one. */
    StopButton stopButton() {
        return new StopButton(team, team::stopAllIfAny);
    }

    /**
     * Connects a robot again in the background.
     *
     * @param ended runs on the event dispatch thread when the attempt has ended
     */
    void reconnect(Member member, Runnable ended) {
        EventThread.background("reconnecting robot " + member.number(), () -> {
            try {
                member.bot().connect();
            } catch (BotException e) {
                String problem = String.valueOf(e.getMessage());
                channel.showError(member.number() + ": " + member.bot().type().adviceAfter(problem));
                addresses
                        .apply(member)
                        .filter(address -> isOtherAdapter(e))
                        .ifPresent(address -> EventThread.later(() -> askForOther(member, problem, address)));
            } finally {
                EventThread.later(ended);
            }
        });
    }

    private static boolean isOtherAdapter(BotException failure) {
        return failure instanceof ConnectFailed failed && failed.reason() == ConnectFailed.Reason.OTHER_ADAPTER;
    }

    private void askForOther(Member member, String problem, String address) {
        Confirm.ask(
                KeyboardFocusManager.getCurrentKeyboardFocusManager().getActiveWindow(),
                TEXTS.get(
                        "otherAdapter", member.number(), ErrorWords.of(problem).replace("; ", ";\n")),
                TEXTS.get("otherAdapter.yes"),
                () -> channel.submit("add " + address + " as " + member.number()));
    }

    /** Returns when a lost robot is connected again; empty if nothing is tried. */
    Optional<AutoReconnect.Status> attempts(Member member) {
        return attempts.status(member);
    }

    /** Leaves a lost robot unconnected. */
    void cancelReconnect(Member member) {
        attempts.cancel(member);
    }

    /** Submits a command for one robot, without its number. */
    void submit(Member member, String command) {
        channel.submit(member.number() + " " + command);
    }

    void loadAct(Member member) {
        loadAct.accept(member);
    }

    void endAct(Member member) {
        channel.submit(member.number() + " act off");
    }

    void kill(Member member) {
        kill.accept(member);
    }

    /**
     * Opens the dialog that renames a robot.
     *
     * @param on a component of the window that the dialog belongs to
     */
    void rename(Member member, Component on) {
        new RenameDialog(SwingUtilities.getWindowAncestor(on), member, channel).setVisible(true);
    }

    /** Returns the plots of what the robots report. */
    Plots plots() {
        return plots;
    }

    /** Shows a message that does not come from the session. */
    void showError(String sentence) {
        channel.showError(sentence);
    }
}
