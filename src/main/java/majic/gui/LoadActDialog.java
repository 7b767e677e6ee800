package majic.gui;

import java.awt.Window;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import majic.bot.Member;
import net.miginfocom.swing.MigLayout;

/** Chooses the robot that is to get a behaviour; asks first if something runs on it. */
final class LoadActDialog extends MajicDialog {
    private static final long serialVersionUID = 1L;

    private final MemberChoice choice;
    private final transient Consumer<Member> load;

    LoadActDialog(Window owner, List<Member> members, Optional<Member> current, Consumer<Member> load) {
        super(owner, "Load Act");
        this.load = load;
        choice = new MemberChoice(members, current);
        JPanel content = new JPanel(new MigLayout("insets 0, gap 8 10", "[][grow, fill]", ""));
        content.add(new JLabel("Robot"));
        content.add(choice, "wmin 260");
        JButton ok = button("OK", this::chosen);
        fill(content, ok, closing("Cancel"));
    }

    private void chosen() {
        Member member = choice.chosen();
        String owner = BotStatus.owner(member);
        dispose();
        if (owner.isEmpty()) {
            load.accept(member);
        } else {
            Confirm.ask(
                    getOwner(),
                    "Robot " + member.number() + " is " + owner + ". End that and load another act?",
                    "Yes",
                    () -> load.accept(member));
        }
    }
}
