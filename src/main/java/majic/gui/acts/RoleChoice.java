package majic.gui.acts;

import java.awt.Window;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.SwingUtilities;
import majic.act.Role;
import majic.gui.kit.MajicDialog;
import majic.gui.kit.MemberChoice;
import majic.gui.kit.Mnemonics;
import majic.gui.kit.Palette;
import majic.gui.kit.Paragraph;
import majic.team.Member;
import majic.text.Texts;
import net.miginfocom.swing.MigLayout;

/**
 * Offers the robots that can take one role, for one choice, or several where the role takes more; shows below why
 * others cannot.
 */
final class RoleChoice extends JPanel {
    private static final long serialVersionUID = 1L;
    private static final Texts TEXTS = Texts.of(RoleChoice.class);

    private final transient Role role;
    private final transient List<Member> fit;
    private final transient List<MemberChoice> choices = new ArrayList<>();
    private final JPanel rows =
            new JPanel(new MigLayout("insets 0, gap 4 4, wrap 3, hidemode 3", "[grow, fill][][]", ""));
    private final JButton more = MajicDialog.button(TEXTS.get("oneMore"), this::addOne);
    private final JButton fewer = MajicDialog.button(TEXTS.get("oneFewer"), this::removeOne);

    /**
     * Creates a choice that starts with a robot not yet assigned to a role, if there is one.
     *
     * @param taken the robots of other roles
     */
    RoleChoice(Role role, LoadTarget target, List<Member> members, Set<Member> taken) {
        super(new MigLayout("insets 0, gap 0 4, wrap 1", "[grow, fill]", ""));
        this.role = role;
        fit = members.stream()
                .filter(member -> RoleFit.unfit(role, member, target).isEmpty())
                .toList();
        if (fit.isEmpty()) {
            JLabel none = new JLabel(TEXTS.get("noRobot"));
            none.setForeground(Palette.error());
            add(none);
        } else {
            add(rows, "wmin 0");
            add(taken);
        }
        more.setVisible(role.several());
        fewer.setVisible(role.several());
        add(why(role, target, members), "wmin 0");
    }

    /** Returns the chosen robots, in the order shown; empty if no robot can take the role. */
    List<Member> chosen() {
        return choices.stream().map(MemberChoice::chosen).toList();
    }

    private void addOne() {
        add(Set.copyOf(chosen()));
    }

    /** Adds one more choice that starts with a robot not assigned to another role. */
    private void add(Set<Member> taken) {
        Optional<Member> free =
                fit.stream().filter(member -> !taken.contains(member)).findFirst();
        MemberChoice choice = new MemberChoice(fit, free);
        choice.setName("role " + role.name() + (choices.isEmpty() ? "" : " " + (choices.size() + 1)));
        choice.getAccessibleContext().setAccessibleName(TEXTS.get("robotFor", role.name()));
        boolean first = choices.isEmpty();
        choices.add(choice);
        rows.add(choice, first ? "wmin 0" : "wmin 0, wrap");
        if (first) {
            rows.add(more);
            rows.add(fewer);
        }
        changed();
    }

    private void removeOne() {
        rows.remove(choices.remove(choices.size() - 1));
        changed();
    }

    private void changed() {
        more.setEnabled(choices.size() < fit.size());
        fewer.setEnabled(choices.size() > 1);
        Window window = SwingUtilities.getWindowAncestor(this);
        if (window != null) {
            Mnemonics.assign(window);
            window.setMinimumSize(null);
            window.pack();
        }
    }

    private static Paragraph why(Role role, LoadTarget target, List<Member> members) {
        String others = members.stream()
                .filter(member -> member != target.member())
                .flatMap(member -> RoleFit.unfit(role, member, target).stream())
                .collect(Collectors.joining("\n"));
        String wanted = TEXTS.get("wanted", RoleFit.wanted(role));
        Paragraph why = new Paragraph("why " + role.name(), 1, 40);
        why.showFaint(others.isEmpty() ? wanted : wanted + "\n" + others);
        return why;
    }
}
