package majic.gui.acts;

import java.awt.Component;
import javax.swing.DefaultListCellRenderer;
import javax.swing.JList;
import majic.gui.kit.Palette;
import majic.team.Member;

/** Shows an act in a list; paler, and in words, if the robot cannot run it. Its name is never interpreted as HTML. */
final class ActCell extends DefaultListCellRenderer {
    private static final long serialVersionUID = 1L;

    private final transient Member member;

    ActCell(Member member) {
        this.member = member;
        putClientProperty("html.disable", Boolean.TRUE);
    }

    @Override
    public Component getListCellRendererComponent(
            JList<?> list, Object value, int index, boolean selected, boolean focused) {
        super.getListCellRendererComponent(list, value, index, selected, focused);
        if (((ActEntry) value).unfit(member).isPresent()) {
            setText(value + " \u2013 not for this robot");
            setForeground(selected ? getForeground() : Palette.faint());
        }
        return this;
    }
}
