package majic.gui.acts;

import java.awt.Window;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.JButton;
import javax.swing.JPanel;
import majic.gui.kit.Confirm;
import majic.gui.kit.HelpTopic;
import majic.gui.kit.MajicDialog;
import majic.gui.kit.MemberChoice;
import majic.team.Member;
import majic.text.Texts;
import net.miginfocom.swing.MigLayout;

/**
 * Chooses the robot, or the selected robots, onto which an act is loaded; asks first if one of them runs an act or a
 * script.
 */
public final class LoadActDialog extends MajicDialog {
    private static final long serialVersionUID = 1L;
    private static final Texts TEXTS = Texts.of(LoadActDialog.class);

    private final MemberChoice choice;
    private final transient Consumer<LoadTargets> load;

    /**
     * Creates the dialog.
     *
     * @param chosen the robots that are chosen at first
     * @param load continues with the chosen robots
     */
    public LoadActDialog(Window owner, List<Member> members, List<Member> chosen, Consumer<LoadTargets> load) {
        super(owner, TEXTS.get("loadAct"));
        HelpTopic.set(getRootPane(), "loading-acts");
        this.load = load;
        choice = new MemberChoice(members, chosen);
        JPanel content = new JPanel(new MigLayout("insets 0, gap 8 10", "[][grow, fill]", ""));
        content.add(label(TEXTS.get("robot"), choice));
        content.add(choice, "wmin 260");
        JButton ok = button(TEXTS.get("ok"), this::chosen);
        fill(content, ok, closing(TEXTS.get("cancel")));
    }

    private void chosen() {
        LoadTargets targets = LoadTargets.of(choice.allChosen());
        dispose();
        targets.question()
                .ifPresentOrElse(
                        question -> Confirm.ask(getOwner(), question, TEXTS.get("yes"), () -> load.accept(targets)),
                        () -> load.accept(targets));
    }
}
