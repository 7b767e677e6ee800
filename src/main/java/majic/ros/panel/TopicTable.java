package majic.ros.panel;

import java.util.List;
import java.util.Locale;
import javax.swing.table.AbstractTableModel;
import majic.panel.ReadingsPanel;
import majic.text.Texts;

/** The topics that are received, with the ages of their newest messages. For the event dispatch thread. */
final class TopicTable extends AbstractTableModel {
    private static final long serialVersionUID = 1;
    private static final Texts TEXTS = Texts.of(TopicTable.class);
    private static final List<String> COLUMNS = List.of("topic.name", "topic.type", "topic.age");
    private static final int AGE = 2;

    /** From this age on, tenths of a second say nothing. */
    private static final double LONG_S = 10;

    private transient List<RosScene.Topic> topics = List.of();

    /** Shows topics; the selection stays while the topics are the same. */
    void show(List<RosScene.Topic> shown) {
        boolean same = names(topics).equals(names(shown));
        topics = shown;
        if (!same) {
            fireTableDataChanged();
        } else if (!shown.isEmpty()) {
            fireTableRowsUpdated(0, shown.size() - 1);
        }
    }

    private static List<String> names(List<RosScene.Topic> topics) {
        return topics.stream().map(RosScene.Topic::name).toList();
    }

    /** Returns a topic for a tooltip. */
    String tip(int row) {
        return topics.get(row).name() + ", " + topics.get(row).type();
    }

    @Override
    public int getRowCount() {
        return topics.size();
    }

    @Override
    public int getColumnCount() {
        return COLUMNS.size();
    }

    @Override
    public String getColumnName(int column) {
        return TEXTS.get(COLUMNS.get(column));
    }

    @Override
    public Object getValueAt(int row, int column) {
        RosScene.Topic topic = topics.get(row);
        if (column == AGE) {
            return age(topic.ageS());
        }
        return column == 0 ? topic.name() : topic.type().replaceFirst(".*/", "");
    }

    private static String age(double seconds) {
        if (!Double.isFinite(seconds)) {
            return ReadingsPanel.NONE;
        }
        return String.format(Locale.ROOT, seconds < LONG_S ? "%.1f s" : "%.0f s", seconds);
    }
}
