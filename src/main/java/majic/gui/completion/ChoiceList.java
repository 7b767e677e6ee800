package majic.gui.completion;

import java.awt.Font;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.DefaultListModel;
import javax.swing.JList;
import javax.swing.ListSelectionModel;
import majic.script.help.Completion;
import majic.text.Texts;

/** The list in the popup of a text. Must be used on the event dispatch thread. */
final class ChoiceList extends JList<Completion> {
    private static final long serialVersionUID = 1L;
    private static final Texts TEXTS = Texts.of(ChoiceList.class);

    private final DefaultListModel<Completion> entries = new DefaultListModel<>();
    private final CompletionCell cell = new CompletionCell();

    /**
     * Creates an empty list.
     *
     * @param clicked receives the entry that is clicked
     */
    ChoiceList(Consumer<Completion> clicked) {
        setModel(entries);
        setName("choices");
        getAccessibleContext().setAccessibleName(TEXTS.get("completions"));
        setFocusable(false);
        setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
        setCellRenderer(cell);
        addMouseListener(new MouseAdapter() {
            @Override
            public void mousePressed(MouseEvent event) {
                int index = locationToIndex(event.getPoint());
                if (index >= 0 && !entries.get(index).isHint()) {
                    clicked.accept(entries.get(index));
                }
            }
        });
    }

    /** Returns true: a list that is made narrower shortens the explanations. */
    @Override
    public boolean getScrollableTracksViewportWidth() {
        return true;
    }

    /** Replaces the entries; none of them is selected. */
    void show(List<Completion> choices, Font font) {
        entries.clear();
        entries.addAll(choices);
        cell.measure(choices, font);
        setFixedCellHeight(cell.getPreferredSize().height);
        setFixedCellWidth(cell.getPreferredSize().width);
        clearSelection();
        ensureIndexIsVisible(0);
    }

    /** Returns the index of the last entry that can be chosen; -1 if there is none. */
    int lastChoice() {
        int last = entries.size() - 1;
        while (last >= 0 && entries.get(last).isHint()) {
            last--;
        }
        return last;
    }

    /** Selects an entry; another index selects none. */
    void select(int index) {
        clearSelection();
        if (index >= 0 && index < entries.size()) {
            setSelectedIndex(index);
            ensureIndexIsVisible(index);
        }
    }
}
