package majic.gui.replay;

import java.util.List;
import java.util.Map;
import javax.swing.JComponent;
import javax.swing.JScrollPane;
import javax.swing.JTable;
import javax.swing.SwingUtilities;
import javax.swing.table.AbstractTableModel;
import majic.bot.BotType.ReplayDisplay;
import majic.bot.MajicBot;
import majic.bot.Parameter;
import majic.panel.PlotLink;
import majic.text.Texts;

/** Shows all recorded parameters of a robot that has no panel for replays. */
final class ReadingsTable implements ReplayDisplay {
    private static final Texts TEXTS = Texts.of(ReadingsTable.class);
    private final Readings readings;
    private final JScrollPane pane;

    ReadingsTable(MajicBot bot) {
        readings = new Readings(bot);
        JTable table = new JTable(readings);
        table.setName("readings");
        table.setFillsViewportHeight(true);
        table.getAccessibleContext().setAccessibleName(TEXTS.get("readings"));
        PlotLink.install(table, List.of(), point -> readings.nameAt(table.rowAtPoint(point)));
        pane = new JScrollPane(table);
    }

    @Override
    public JComponent component() {
        return pane;
    }

    @Override
    public void reset() {}

    @Override
    public void show(Map<String, String> state, long nanos) {
        SwingUtilities.invokeLater(readings::refresh);
    }

    /** One row for each parameter. */
    private static final class Readings extends AbstractTableModel {
        private static final long serialVersionUID = 1;

        private final transient MajicBot bot;
        private final transient List<Parameter> parameters;

        Readings(MajicBot bot) {
            this.bot = bot;
            this.parameters =
                    bot.parameters().stream().filter(Parameter::readable).toList();
        }

        List<String> nameAt(int row) {
            return row < 0 ? List.of() : List.of(parameters.get(row).name());
        }

        void refresh() {
            fireTableRowsUpdated(0, parameters.size() - 1);
        }

        @Override
        public int getRowCount() {
            return parameters.size();
        }

        @Override
        public int getColumnCount() {
            return 2;
        }

        @Override
        public String getColumnName(int column) {
            return TEXTS.get(column == 0 ? "reading" : "value");
        }

        @Override
        public String getValueAt(int row, int column) {
            String name = parameters.get(row).name();
            return column == 0 ? name : bot.get(name).toString();
        }
    }
}
