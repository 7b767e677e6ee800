package majic.gui;

import java.awt.Dimension;
import java.awt.Window;
import java.util.List;
import java.util.Optional;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTabbedPane;
import javax.swing.JTable;
import javax.swing.table.TableModel;
import majic.gui.kit.MajicDialog;
import majic.gui.kit.MemberChoice;
import majic.team.Member;
import net.miginfocom.swing.MigLayout;

/** Shows the commands, the parameters of each robot, and the keys. */
final class HelpDialog extends MajicDialog {
    private static final long serialVersionUID = 1L;
    private static final int TABLE_WIDTH = 820;

    HelpDialog(Window owner, List<Member> members, Optional<Member> current) {
        super(owner, "Help");
        JTabbedPane tabs = new JTabbedPane();
        tabs.addTab("Commands", scrolled(table(HelpTables.file("commands", "Command", "What it does"), 300)));
        if (!members.isEmpty()) {
            tabs.addTab("Parameters", parameters(members, current));
        }
        tabs.addTab("Keys", scrolled(table(HelpTables.file("keys", "Key", "What it does"), 230)));
        tabs.setPreferredSize(new Dimension(TABLE_WIDTH, 480));
        fill(tabs, closing("Close"));
    }

    private static JPanel parameters(List<Member> members, Optional<Member> current) {
        MemberChoice choice = new MemberChoice(members, current);
        JTable table = table(HelpTables.of(choice.chosen()), 130);
        choice.addActionListener(event -> {
            table.setModel(HelpTables.of(choice.chosen()));
            widen(table, 130);
        });
        widen(table, 130);
        JPanel panel = new JPanel(new MigLayout("insets 8 0 0 0", "[grow, fill]", "[][grow, fill]"));
        panel.add(choice, "grow 0, wmin 220, wrap");
        panel.add(scrolled(table));
        return panel;
    }

    private static JTable table(TableModel model, int firstWidth) {
        JTable table = new JTable(model);
        table.setShowHorizontalLines(true);
        table.setAutoResizeMode(JTable.AUTO_RESIZE_LAST_COLUMN);
        table.getTableHeader().setReorderingAllowed(false);
        widen(table, firstWidth);
        return table;
    }

    private static void widen(JTable table, int firstWidth) {
        int last = table.getColumnCount() - 1;
        for (int column = 0; column < last; column++) {
            table.getColumnModel().getColumn(column).setPreferredWidth(firstWidth);
        }
        table.getColumnModel().getColumn(last).setPreferredWidth(TABLE_WIDTH - last * firstWidth);
    }

    private static JScrollPane scrolled(JTable table) {
        return new JScrollPane(table);
    }
}
