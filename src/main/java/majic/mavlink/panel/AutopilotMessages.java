package majic.mavlink.panel;

import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.event.MouseEvent;
import java.util.List;
import javax.swing.AbstractListModel;
import javax.swing.BorderFactory;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.ListCellRenderer;
import javax.swing.ListSelectionModel;
import javax.swing.UIManager;
import majic.panel.DrawingColors;
import majic.panel.ReadingText;
import majic.panel.StatusLight.Kind;
import majic.text.Texts;

/**
 * The newest texts of the autopilot, the newest at the top, each with its severity as a shape and a colour, and its
 * age. Ctrl+C copies the selected ones. For the event dispatch thread.
 */
final class AutopilotMessages extends JPanel {
    private static final long serialVersionUID = 1;
    private static final Texts TEXTS = Texts.of(AutopilotMessages.class);
    private static final int ROWS = 3;

    private final Rows rows = new Rows();
    private final JList<Row> list = new MessageList(rows);

    /**
     * A text as it is shown.
     *
     * @param age in words; empty if it is not known
     */
    private record Row(VehicleScene.Severity kind, String text, String age) {
        static Row of(VehicleScene.Message message) {
            String age = Double.isNaN(message.ageS()) ? "" : ReadingText.age(message.ageS());
            return new Row(message.kind(), message.text(), age);
        }

        /** The text that is copied. */
        @Override
        public String toString() {
            return text;
        }
    }

    AutopilotMessages() {
        super(new BorderLayout());
        setOpaque(false);
        list.setName("messages");
        list.getAccessibleContext().setAccessibleName(TEXTS.get("messages"));
        list.setCellRenderer(new RowView());
        list.setVisibleRowCount(ROWS);
        list.setSelectionMode(ListSelectionModel.MULTIPLE_INTERVAL_SELECTION);
        JLabel title = new JLabel(TEXTS.get("messages"));
        title.setLabelFor(list);
        title.setBorder(BorderFactory.createEmptyBorder(2, 0, 2, 0));
        add(title, BorderLayout.NORTH);
        add(new JScrollPane(list), BorderLayout.CENTER);
    }

    void show(List<VehicleScene.Message> messages, boolean current) {
        rows.show(messages.stream().map(Row::of).toList());
        list.setEnabled(current);
    }

    /** Changes only if a row looks different, so that the selection stays. */
    private static final class Rows extends AbstractListModel<Row> {
        private static final long serialVersionUID = 1;
        private transient List<Row> shown = List.of();

        void show(List<Row> rows) {
            if (rows.equals(shown)) {
                return;
            }
            int added = rows.size() - shown.size();
            int removed = shown.size() - 1;
            if (added < 0) {
                shown = List.of();
                fireIntervalRemoved(this, 0, removed);
            }
            int before = shown.size();
            shown = rows;
            if (rows.size() > before) {
                fireIntervalAdded(this, 0, rows.size() - before - 1);
            }
            fireContentsChanged(this, 0, rows.size() - 1);
        }

        @Override
        public int getSize() {
            return shown.size();
        }

        @Override
        public Row getElementAt(int index) {
            return shown.get(index);
        }
    }

    /** Shows the whole text, which may be cut in its row. */
    private static final class MessageList extends JList<Row> {
        private static final long serialVersionUID = 1;

        MessageList(Rows rows) {
            super(rows);
        }

        @Override
        public String getToolTipText(MouseEvent event) {
            int index = locationToIndex(event.getPoint());
            return index < 0 || !getCellBounds(index, index).contains(event.getPoint())
                    ? TEXTS.get("messages.tip")
                    : words(getModel().getElementAt(index));
        }

        /** Rows are as wide as the list: the text is cut before the age. */
        @Override
        public boolean getScrollableTracksViewportWidth() {
            return true;
        }
    }

    private static String words(Row row) {
        return switch (row.kind()) {
            case ERROR -> TEXTS.get("error", row.text());
            case WARNING -> TEXTS.get("warning", row.text());
            case INFO -> TEXTS.get("info", row.text());
        };
    }

    private static final class RowView extends JPanel implements ListCellRenderer<Row> {
        private static final long serialVersionUID = 1;
        private final JLabel text = new JLabel();
        private final JLabel age = new JLabel();

        RowView() {
            super(new BorderLayout(6, 0));
            setBorder(BorderFactory.createEmptyBorder(1, 4, 1, 4));
            add(text, BorderLayout.CENTER);
            add(age, BorderLayout.EAST);
        }

        @Override
        public Component getListCellRendererComponent(
                JList<? extends Row> list, Row row, int index, boolean selected, boolean focused) {
            text.setText(row.text());
            text.setIcon(
                    switch (row.kind()) {
                        case ERROR -> Kind.ALARM;
                        case WARNING -> Kind.WARNING;
                        case INFO -> Kind.QUIET;
                    });
            text.setDisabledIcon(Kind.QUIET);
            age.setText(row.age());
            DrawingColors colors = DrawingColors.current();
            boolean red = row.kind() == VehicleScene.Severity.ERROR && !selected;
            text.setForeground(red ? colors.alarm() : selected ? list.getSelectionForeground() : list.getForeground());
            age.setForeground(selected ? list.getSelectionForeground() : colors.faint());
            setBackground(selected ? list.getSelectionBackground() : list.getBackground());
            text.setEnabled(list.isEnabled());
            age.setEnabled(list.isEnabled());
            setBorder(
                    focused
                            ? UIManager.getBorder("List.focusCellHighlightBorder")
                            : BorderFactory.createEmptyBorder(1, 4, 1, 4));
            getAccessibleContext().setAccessibleName(words(row) + " " + row.age());
            return this;
        }
    }
}
