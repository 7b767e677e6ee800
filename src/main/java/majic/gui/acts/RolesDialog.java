package majic.gui.acts;

import java.awt.Window;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import majic.act.Role;
import majic.gui.kit.HelpTopic;
import majic.gui.kit.MajicDialog;
import majic.gui.kit.MemberChoice;
import majic.gui.kit.NamedLabel;
import majic.gui.kit.Paragraph;
import majic.script.ActOffer;
import majic.team.Member;
import majic.text.Texts;
import net.miginfocom.swing.MigLayout;

/** Assigns a robot to each further role of an act. Offers only suitable robots, and shows why the others are not. */
final class RolesDialog extends MajicDialog {
    private static final long serialVersionUID = 1L;
    private static final Texts TEXTS = Texts.of(RolesDialog.class);

    private final transient List<RoleChoice> choices = new ArrayList<>();
    private final Paragraph outcome = new Paragraph("rolesOutcome", 1, 40);
    private final transient Consumer<List<Integer>> assigned;

    /**
     * Creates the dialog, not yet shown.
     *
     * @param assigned receives the robots' numbers, in the order of the roles
     */
    RolesDialog(
            Window owner, ActOffer offer, LoadTarget target, List<Member> members, Consumer<List<Integer>> assigned) {
        super(owner, TEXTS.get("assignRoles"));
        HelpTopic.set(getRootPane(), "loading-acts");
        this.assigned = assigned;
        JPanel content = new JPanel(new MigLayout("insets 0, gap 12 6", "[right, ::160][360:400:, grow, fill]", ""));
        content.add(
                new NamedLabel(
                        "rolesOf", TEXTS.get("needsRobots", offer.details().name())),
                "spanx 2, growx, wmin 0, gapbottom 4, wrap");
        row(content, "me", new JLabel(new MemberChoice.Entry(target.member()).toString()));
        LinkedHashSet<Member> taken = new LinkedHashSet<>();
        for (Role role : offer.roles().subList(1, offer.roles().size())) {
            RoleChoice choice = new RoleChoice(role, target, members, taken);
            taken.addAll(choice.chosen());
            choices.add(choice);
            row(content, role.name(), choice);
        }
        content.add(outcome, "spanx 2, growx, wmin 0");
        JButton load = button(TEXTS.get("load"), this::load);
        load.setName("loadChosen");
        load.setEnabled(choices.stream().allMatch(choice -> !choice.chosen().isEmpty()));
        fill(content, load, closing(TEXTS.get("cancel")));
    }

    private static void row(JPanel content, String role, JComponent value) {
        JLabel name = new NamedLabel("roleOf" + role, role);
        name.putClientProperty("FlatLaf.style", "font: bold");
        content.add(name, "aligny top, gaptop 4, wmin 0");
        content.add(value, "wmin 0, wrap");
    }

    private void load() {
        List<Member> robots =
                choices.stream().flatMap(choice -> choice.chosen().stream()).toList();
        if (new LinkedHashSet<>(robots).size() < robots.size()) {
            outcome.show(TEXTS.get("twoRoles"), true);
            return;
        }
        dispose();
        assigned.accept(robots.stream().map(Member::number).toList());
    }
}
