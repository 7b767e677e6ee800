package majic.ros.panel;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.event.MouseEvent;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTable;
import javax.swing.SwingConstants;
import javax.swing.table.DefaultTableCellRenderer;
import majic.text.Texts;

/** Shows the topics in a table that can be scrolled. For the event dispatch thread. */
final class TopicsPanel extends JPanel {
    private static final long serialVersionUID = 1;
    private static final Texts TEXTS = Texts.of(TopicsPanel.class);
    private static final String LONGEST_AGE = "  8888 s  ";
    private static final String LONG_NAME = "  /robot1/battery_state  ";
    private static final String LONG_TYPE = "  CompressedImage  ";
    private static final int AGE = 2;

    private final TopicTable topics = new TopicTable();
    private final JTable table = new Table(topics);

    TopicsPanel() {
        super(new BorderLayout());
        setOpaque(false);
        table.setName("topics");
        table.getAccessibleContext().setAccessibleName(TEXTS.get("topics"));
        table.setFillsViewportHeight(true);
        table.getColumnModel().getColumn(AGE).setCellRenderer(trailing());
        table.getColumnModel().getColumn(0).setPreferredWidth(widthOf(LONG_NAME));
        table.getColumnModel().getColumn(1).setPreferredWidth(widthOf(LONG_TYPE));
        table.getColumnModel().getColumn(AGE).setMinWidth(widthOf(LONGEST_AGE));
        table.getColumnModel().getColumn(AGE).setMaxWidth(widthOf(LONGEST_AGE));
        add(new JScrollPane(table));
    }

    private static DefaultTableCellRenderer trailing() {
        DefaultTableCellRenderer cell = new DefaultTableCellRenderer();
        cell.setHorizontalAlignment(SwingConstants.TRAILING);
        return cell;
    }

    private int widthOf(String text) {
        return table.getFontMetrics(table.getFont()).stringWidth(text);
    }

    void show(RosScene scene) {
        topics.show(scene.topics());
        table.setEnabled(scene.isConnected());
    }

    /** Must not determine the width of the panel: names of topics may be very long. */
    @Override
    public Dimension getMinimumSize() {
        return new Dimension(0, 0);
    }

    /** Shows the whole name, which may be cut in its cell. */
    private static final class Table extends JTable {
        private static final long serialVersionUID = 1;

        private final TopicTable topics;

        Table(TopicTable topics) {
            super(topics);
            this.topics = topics;
        }

        @Override
        public String getToolTipText(MouseEvent event) {
            int row = rowAtPoint(event.getPoint());
            return row < 0 ? null : topics.tip(row);
        }
    }
}
