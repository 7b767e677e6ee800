package majic.gui.acts;

import java.awt.Component;
import javax.swing.DefaultListCellRenderer;
import javax.swing.JList;
import majic.gui.kit.Palette;
import majic.text.Texts;

/** Shows an act in a list; paler, and in words, if a robot cannot run it. */
final class ActCell extends DefaultListCellRenderer {
    private static final long serialVersionUID = 1L;
    private static final Texts TEXTS = Texts.of(ActCell.class);

    private final transient LoadTargets targets;

    ActCell(LoadTargets targets) {
        this.targets = targets;
    }

    @Override
    public Component getListCellRendererComponent(
            JList<?> list, Object value, int index, boolean selected, boolean focused) {
        super.getListCellRendererComponent(list, value, index, selected, focused);
        if (targets.unfit((ActEntry) value).isPresent()) {
            setText(TEXTS.get("doesNotFit", value));
            setForeground(selected ? getForeground() : Palette.faint());
        }
        return this;
    }
}
