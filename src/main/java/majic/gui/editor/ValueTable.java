package majic.gui.editor;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.Font;
import java.util.List;
import javax.swing.BorderFactory;
import javax.swing.JLabel;
import javax.swing.JScrollPane;
import javax.swing.JTable;
import javax.swing.SwingConstants;
import javax.swing.table.AbstractTableModel;
import javax.swing.table.DefaultTableCellRenderer;
import majic.gui.kit.Palette;
import majic.script.run.ScriptControl.NamedValue;
import majic.text.Texts;

/**
 * The names of a script with their values, beside the text of a script that is paused. The names whose values the last
 * line has changed are marked. Hidden while there are none.
 */
final class ValueTable extends JScrollPane {
    private static final long serialVersionUID = 1L;
    private static final Texts TEXTS = Texts.of(ValueTable.class);
    private static final int WIDTH = 230;

    private final Model model = new Model();
    private final JTable table = new JTable(model);

    ValueTable() {
        setViewportView(table);
        table.setName("scriptValues");
        table.getAccessibleContext().setAccessibleName(TEXTS.get("values"));
        table.setDefaultRenderer(Object.class, new Cell());
        table.getTableHeader().setReorderingAllowed(false);
        if (table.getTableHeader().getDefaultRenderer() instanceof JLabel label) {
            label.setHorizontalAlignment(SwingConstants.LEADING);
        }
        table.setCellSelectionEnabled(false);
        table.setFocusable(false);
        setBorder(BorderFactory.createMatteBorder(0, 1, 0, 0, Palette.mixed(0.15)));
        setVisible(false);
    }

    /** Updates the border for the look and feel. */
    @Override
    public void updateUI() {
        super.updateUI();
        setBorder(BorderFactory.createMatteBorder(0, 1, 0, 0, Palette.mixed(0.15)));
    }

    @Override
    public Dimension getPreferredSize() {
        return new Dimension(UIScale.scale(WIDTH), super.getPreferredSize().height);
    }

    /** Shows values in place of those shown before. */
    void show(List<NamedValue> values) {
        if (values.equals(model.values)) {
            return;
        }
        model.values = List.copyOf(values);
        model.fireTableDataChanged();
        if (isVisible() == values.isEmpty()) {
            setVisible(!values.isEmpty());
            revalidate();
        }
    }

    /** A row for each name. */
    private static final class Model extends AbstractTableModel {
        private static final long serialVersionUID = 1L;
        private transient List<NamedValue> values = List.of();

        @Override
        public int getRowCount() {
            return values.size();
        }

        @Override
        public int getColumnCount() {
            return 2;
        }

        @Override
        public String getColumnName(int column) {
            return TEXTS.get(column == 0 ? "values.name" : "values.value");
        }

        @Override
        public Object getValueAt(int row, int column) {
            NamedValue value = values.get(row);
            return column == 0 ? "$" + value.name() : value.value().toString();
        }
    }

    /** A name or its value; those that have changed are bold on the colour of the line that runs next. */
    private final class Cell extends DefaultTableCellRenderer {
        private static final long serialVersionUID = 1L;

        @Override
        public Component getTableCellRendererComponent(
                JTable of, Object value, boolean selected, boolean focused, int row, int column) {
            super.getTableCellRendererComponent(of, value, false, false, row, column);
            boolean changed = model.values.get(row).changed();
            setFont(changed ? of.getFont().deriveFont(Font.BOLD) : of.getFont());
            setForeground(Palette.text());
            setBackground(changed ? EditorColors.current().next() : of.getBackground());
            setToolTipText(changed ? TEXTS.get("values.changed", value) : String.valueOf(value));
            getAccessibleContext().setAccessibleName(getToolTipText());
            return this;
        }
    }
}
