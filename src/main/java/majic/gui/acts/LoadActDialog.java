package majic.gui.acts;

import java.awt.Window;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.JButton;
import javax.swing.JPanel;
import majic.gui.kit.BotStatus;
import majic.gui.kit.Confirm;
import majic.gui.kit.Html;
import majic.gui.kit.MajicDialog;
import majic.gui.kit.MemberChoice;
import majic.team.Member;
import majic.team.Owner;
import net.miginfocom.swing.MigLayout;

/** Chooses the robot onto which an act is loaded; asks first if an act or a script already runs on it. */
public final class LoadActDialog extends MajicDialog {
    private static final long serialVersionUID = 1L;

    private final MemberChoice choice;
    private final transient Consumer<LoadTarget> load;

    public LoadActDialog(Window owner, List<Member> members, Optional<Member> current, Consumer<LoadTarget> load) {
        super(owner, "Load Act");
        this.load = load;
        choice = new MemberChoice(members, current);
        JPanel content = new JPanel(new MigLayout("insets 0, gap 8 10", "[][grow, fill]", ""));
        content.add(label("Robot", choice));
        content.add(choice, "wmin 260");
        JButton ok = button("OK", this::chosen);
        fill(content, ok, closing("Cancel"));
    }

    private void chosen() {
        LoadTarget target = LoadTarget.of(choice.chosen());
        dispose();
        if (target.ends() == null) {
            load.accept(target);
        } else {
            Confirm.ask(getOwner(), question(target.member()), "Yes", () -> load.accept(target));
        }
    }

    private static String question(Member member) {
        Owner lender = member.lender();
        String within = lender == null ? "" : ", part of the script " + Html.escaped(lender.name());
        return "<html>Robot " + member.number() + " is " + Html.escaped(BotStatus.owner(member)) + within
                + ". End it and load another act?<br>It continues until the new act starts.";
    }
}
