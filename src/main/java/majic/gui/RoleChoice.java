package majic.gui;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import javax.swing.JLabel;
import javax.swing.JPanel;
import majic.act.Role;
import majic.bot.Member;
import net.miginfocom.swing.MigLayout;

/** The robots that can play one role, to choose from, and below why the others cannot. */
final class RoleChoice extends JPanel {
    private static final long serialVersionUID = 1L;

    private final MemberChoice choice;

    /**
     * A choice that begins with a robot nobody has taken yet, where there is one.
     *
     * @param taken the robots of other roles
     */
    RoleChoice(Role role, LoadTarget target, List<Member> members, Set<Member> taken) {
        super(new MigLayout("insets 0, gap 0 4, wrap 1", "[grow, fill]", ""));
        List<Member> fit = members.stream()
                .filter(member -> RoleFit.unfit(role, member, target).isEmpty())
                .toList();
        choice = new MemberChoice(
                fit, fit.stream().filter(member -> !taken.contains(member)).findFirst());
        choice.setName("role " + role.name());
        if (fit.isEmpty()) {
            JLabel nobody = new JLabel("No robot here can play this part.");
            nobody.setForeground(Palette.error());
            add(nobody);
        } else {
            add(choice, "wmin 0");
        }
        add(why(role, target, members), "wmin 0");
    }

    Optional<Member> chosen() {
        return choice.getSelectedItem() instanceof MemberChoice.Entry entry
                ? Optional.of(entry.member())
                : Optional.empty();
    }

    private static Paragraph why(Role role, LoadTarget target, List<Member> members) {
        String others = members.stream()
                .filter(member -> member != target.member())
                .flatMap(member -> RoleFit.unfit(role, member, target).stream())
                .collect(Collectors.joining("\n"));
        String wanted = "Wanted: " + RoleFit.wanted(role) + ".";
        Paragraph why = new Paragraph("why " + role.name(), 1, 40);
        why.show(others.isEmpty() ? wanted : wanted + "\n" + others, false);
        why.setForeground(Palette.faint());
        return why;
    }
}
