package majic.gui.editor;

import java.awt.Component;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.Collections;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.BorderFactory;
import javax.swing.DefaultListCellRenderer;
import javax.swing.DefaultListModel;
import javax.swing.JList;
import javax.swing.JScrollPane;
import javax.swing.KeyStroke;
import javax.swing.ListSelectionModel;
import majic.gui.kit.Palette;
import majic.panel.KeyAction;
import majic.script.syntax.Mistake;
import majic.text.Texts;

/** The list of a script's mistakes. Hidden while there is none. */
final class MistakeList extends JScrollPane {
    private static final long serialVersionUID = 1L;
    private static final Texts TEXTS = Texts.of(MistakeList.class);
    private static final int MOST_ROWS = 5;

    private final DefaultListModel<Mistake> model = new DefaultListModel<>();
    private final JList<Mistake> list = new JList<>(model);

    /**
     * Creates an empty list.
     *
     * @param chosen receives a mistake that was clicked, or chosen with the Enter key
     */
    MistakeList(Consumer<Mistake> chosen) {
        setViewportView(list);
        setBorder(BorderFactory.createEmptyBorder());
        list.setName("mistakes");
        list.getAccessibleContext().setAccessibleName(TEXTS.get("mistakes"));
        list.setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
        list.setCellRenderer(new Cell());
        list.addMouseListener(new MouseAdapter() {
            @Override
            public void mouseClicked(MouseEvent event) {
                choose(chosen);
            }
        });
        KeyAction.bind(list, WHEN_FOCUSED, KeyStroke.getKeyStroke("ENTER"), event -> choose(chosen));
        setVisible(false);
    }

    private void choose(Consumer<Mistake> chosen) {
        Mistake mistake = list.getSelectedValue();
        if (mistake != null) {
            chosen.accept(mistake);
        }
    }

    /** Shows mistakes in place of those shown before. */
    void show(List<Mistake> mistakes) {
        if (mistakes.equals(shown())) {
            return;
        }
        model.clear();
        model.addAll(mistakes);
        list.setVisibleRowCount(Math.min(MOST_ROWS, Math.max(1, mistakes.size())));
        setVisible(!mistakes.isEmpty());
        revalidate();
    }

    private List<Mistake> shown() {
        return Collections.list(model.elements());
    }

    /** A mistake with its place. */
    private static final class Cell extends DefaultListCellRenderer {
        private static final long serialVersionUID = 1L;

        @Override
        public Component getListCellRendererComponent(
                JList<?> list, Object value, int index, boolean selected, boolean focused) {
            super.getListCellRendererComponent(list, value, index, selected, focused);
            Mistake mistake = (Mistake) value;
            setText("\u26A0  " + TEXTS.get("mistake", mistake.line(), mistake.message()));
            setToolTipText(mistake.message());
            if (!selected) {
                setForeground(Palette.error());
            }
            setBorder(BorderFactory.createEmptyBorder(2, 8, 2, 8));
            return this;
        }
    }
}
