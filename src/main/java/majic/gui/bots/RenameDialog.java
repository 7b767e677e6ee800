package majic.gui.bots;

import java.awt.Window;
import java.util.Optional;
import javax.swing.JButton;
import javax.swing.JPanel;
import javax.swing.JTextField;
import majic.gui.kit.CommandChannel;
import majic.gui.kit.MajicDialog;
import majic.gui.kit.Paragraph;
import majic.team.Member;
import majic.text.Texts;
import net.miginfocom.swing.MigLayout;

/** Gives a robot a name, or takes it away. Stays open while the name is refused, and shows why. */
final class RenameDialog extends MajicDialog {
    private static final long serialVersionUID = 1L;
    private static final Texts TEXTS = Texts.of(RenameDialog.class);

    private final transient Member member;
    private final transient CommandChannel channel;
    private final JTextField name;
    private final Paragraph advice = new Paragraph("renameAdvice", 3, 36);

    RenameDialog(Window owner, Member member, CommandChannel channel) {
        super(owner, TEXTS.get("rename.title", member.number()));
        setName("rename");
        this.member = member;
        this.channel = channel;
        name = new JTextField(member.name(), 20);
        name.setName("robotName");
        name.selectAll();
        JPanel content = new JPanel(new MigLayout("insets 0, gap 8 10", "[][grow, fill]", ""));
        content.add(label(TEXTS.get("rename.name"), name));
        content.add(name, "wrap");
        content.add(advice, "spanx 2, growx, wmin 0");
        JButton ok = button(TEXTS.get("rename"), this::rename);
        ok.setName("OK");
        fill(content, ok, closing(TEXTS.get("rename.cancel")));
        advice.showFaint(TEXTS.get("rename.advice", member.number()));
        focusFirst(name);
    }

    private void rename() {
        String wanted = name.getText().strip();
        channel.submit(member.number() + " name " + (wanted.isEmpty() ? "off" : wanted), this::ended);
    }

    private void ended(Optional<String> refusal) {
        refusal.ifPresentOrElse(reason -> advice.show(reason, true), this::dispose);
    }
}
