package majic.gui.help;

import java.awt.Component;
import java.util.stream.IntStream;
import javax.swing.JTable;
import javax.swing.table.TableColumn;
import javax.swing.table.TableColumnModel;

/** Gives the columns of a table the widths of their texts; in a narrow table only the last column is cut. */
final class TableColumns {
    private static final int MARGIN = 8;

    private TableColumns() {}

    /** Sets the widths for the rows that the table has now. */
    static void fit(JTable table) {
        TableColumnModel columns = table.getColumnModel();
        for (int index = 0; index < columns.getColumnCount(); index++) {
            TableColumn column = columns.getColumn(index);
            int width = widthOf(table, index);
            column.setPreferredWidth(width);
            if (index < columns.getColumnCount() - 1) {
                column.setMinWidth(width);
            }
        }
    }

    /** Returns the width in pixels at which no text of the table is cut. */
    static int widthOf(JTable table) {
        return IntStream.range(0, table.getColumnCount())
                .map(column -> widthOf(table, column))
                .sum();
    }

    private static int widthOf(JTable table, int column) {
        return MARGIN
                + IntStream.range(0, table.getRowCount())
                        .mapToObj(row -> cell(table, row, column))
                        .mapToInt(cell -> cell.getPreferredSize().width)
                        .max()
                        .orElse(0);
    }

    private static Component cell(JTable table, int row, int column) {
        return table.prepareRenderer(table.getCellRenderer(row, column), row, column);
    }
}
