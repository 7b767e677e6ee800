package majic.gui.bots;

import java.awt.Window;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import majic.gui.kit.BotStatus;
import majic.gui.kit.HelpTopic;
import majic.gui.kit.MajicDialog;
import majic.gui.kit.MemberChoice;
import majic.team.Member;
import majic.text.Texts;
import net.miginfocom.swing.MigLayout;

/** Chooses the robot to be removed, and shows what that ends. */
public final class KillBotDialog extends MajicDialog {
    private static final long serialVersionUID = 1L;
    private static final Texts TEXTS = Texts.of(KillBotDialog.class);

    private final MemberChoice choice;
    private final JLabel consequence = new JLabel();

    public KillBotDialog(Window owner, List<Member> members, Optional<Member> current, Consumer<Member> kill) {
        super(owner, TEXTS.get("kill"));
        HelpTopic.set(getRootPane(), "removing-a-robot");
        choice = new MemberChoice(members, current);
        choice.addActionListener(event -> sayWhatEnds());
        JPanel content = new JPanel(new MigLayout("insets 0, gap 8 10", "[][grow, fill]", ""));
        content.add(label(TEXTS.get("kill.robot"), choice));
        content.add(choice, "wmin 220, wrap");
        content.add(consequence, "spanx 2, growx, wmin 340");
        JButton ok = button(TEXTS.get("kill"), () -> {
            dispose();
            kill.accept(choice.chosen());
        });
        ok.setName("OK");
        sayWhatEnds();
        fill(content, ok, closing(TEXTS.get("kill.cancel")));
    }

    private void sayWhatEnds() {
        String owner = BotStatus.owner(choice.chosen());
        consequence.setText(owner.isEmpty() ? TEXTS.get("kill.effect") : TEXTS.get("kill.effect.owned", owner));
    }
}
