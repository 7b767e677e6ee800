package majic.gui.kit;

import java.util.List;
import java.util.Optional;
import javax.swing.JComboBox;
import majic.team.Member;
import majic.text.NumberList;
import majic.text.Texts;

/** A drop-down list of robots. */
public final class MemberChoice extends JComboBox<MemberChoice.Entry> {
    private static final long serialVersionUID = 1L;
    private static final Texts TEXTS = Texts.of(MemberChoice.class);

    /** One robot, or several together, as the list shows them. */
    public record Entry(List<Member> members) {
        public Entry(Member member) {
            this(List.of(member));
        }

        @Override
        public String toString() {
            String numbers = NumberList.of(members.stream().map(Member::number).toList());
            return members.size() == 1 ? numbers + "  " + members.get(0).label() : TEXTS.get("selected", numbers);
        }
    }

    /**
     * Creates a list of these robots.
     *
     * @param first the one selected initially, if any
     */
    public MemberChoice(List<Member> members, Optional<Member> first) {
        this(members, first.stream().toList());
    }

    /**
     * Creates a list of these robots.
     *
     * @param chosen those selected initially; if there are several, the list has a further entry for all of them
     */
    public MemberChoice(List<Member> members, List<Member> chosen) {
        setName("robot");
        if (chosen.size() > 1) {
            addItem(new Entry(chosen));
        }
        members.forEach(member -> addItem(new Entry(member)));
        if (!chosen.isEmpty()) {
            setSelectedItem(new Entry(chosen));
        }
    }

    /** Returns the chosen robot, the first one of several. */
    public Member chosen() {
        return allChosen().get(0);
    }

    public List<Member> allChosen() {
        return getItemAt(getSelectedIndex()).members();
    }
}
