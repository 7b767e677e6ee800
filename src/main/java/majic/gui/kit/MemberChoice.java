package majic.gui.kit;

import java.util.List;
import java.util.Optional;
import javax.swing.JComboBox;
import majic.team.Member;

/** A drop-down list of robots. */
public final class MemberChoice extends JComboBox<MemberChoice.Entry> {
    private static final long serialVersionUID = 1L;

    /** A robot as the list shows it. */
    public record Entry(Member member) {
        @Override
        public String toString() {
            return member.number() + "  " + member.bot().type().label();
        }
    }

    /**
     * Creates a list of these robots.
     *
     * @param first the one selected initially, if any
     */
    public MemberChoice(List<Member> members, Optional<Member> first) {
        setName("robot");
        members.forEach(member -> addItem(new Entry(member)));
        first.map(Entry::new).ifPresent(this::setSelectedItem);
    }

    public Member chosen() {
        return getItemAt(getSelectedIndex()).member();
    }
}
