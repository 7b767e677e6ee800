package majic.gui.bots;

import java.util.Optional;
import javax.swing.JButton;
import javax.swing.JPanel;
import majic.gui.kit.NamedLabel;
import majic.team.AutoReconnect;
import majic.team.Member;
import majic.text.Texts;
import net.miginfocom.swing.MigLayout;

/** Shows when a lost robot is connected again, with the button that cancels this. Hidden while nothing is tried. */
final class ReconnectCountdown extends JPanel {
    private static final long serialVersionUID = 1L;
    private static final Texts TEXTS = Texts.of(ReconnectCountdown.class);

    private final transient Member member;
    private final transient RobotActions actions;
    private final NamedLabel text;
    private final JButton cancel = new JButton(TEXTS.get("retry.cancel"));

    ReconnectCountdown(Member member, RobotActions actions) {
        super(new MigLayout("insets 0, gap 8 0", "[][]push"));
        this.member = member;
        this.actions = actions;
        text = new NamedLabel("reconnecting" + member.number(), "");
        cancel.setName("cancelReconnect" + member.number());
        cancel.setToolTipText(TEXTS.get("retry.cancel.tip"));
        cancel.getAccessibleContext().setAccessibleName(TEXTS.get("retry.cancel.name", member.number()));
        cancel.addActionListener(event -> {
            actions.cancelReconnect(member);
            update();
        });
        setOpaque(false);
        add(text);
        add(cancel, "hmax pref");
        update();
    }

    /** Shows the present state of the attempts. */
    void update() {
        Optional<AutoReconnect.Status> status = actions.attempts(member);
        setVisible(status.isPresent());
        status.ifPresent(now -> text.setText(text(now)));
    }

    /** Puts the state of the attempts into a few words, for a tab. */
    static String shortText(AutoReconnect.Status status) {
        return status.connecting()
                ? TEXTS.get("retry.connecting.short")
                : TEXTS.get("retry.wait.short", status.seconds());
    }

    private static String text(AutoReconnect.Status status) {
        return status.connecting() ? TEXTS.get("retry.connecting") : TEXTS.get("retry.wait", status.seconds());
    }
}
