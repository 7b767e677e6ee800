package majic.gui.help;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.GraphicsConfiguration;
import java.awt.Window;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTabbedPane;
import javax.swing.JTable;
import javax.swing.JTextField;
import javax.swing.RowFilter;
import javax.swing.table.TableModel;
import javax.swing.table.TableRowSorter;
import majic.gui.kit.EventThread;
import majic.gui.kit.MajicDialog;
import majic.gui.kit.MemberChoice;
import majic.gui.kit.TextChange;
import majic.team.Member;
import majic.text.Texts;
import net.miginfocom.swing.MigLayout;

/** Shows the commands, the parameters of each robot, the keys, and the pages of the guide; all can be searched. */
public final class HelpDialog extends MajicDialog {
    private static final Texts TEXTS = Texts.of(HelpDialog.class);
    private static final long serialVersionUID = 1L;
    private static final int LEAST_WIDTH = 820;
    private static final int MOST_WIDTH = 920;

    /** Room for a scroll bar, or for the borders of the dialog on one side, pixels. */
    private static final int EDGES = 20;

    /** The pages of the user's guide, in the order in which its first page lists the others. */
    static final List<String> GUIDE = List.of(
            "user-guide",
            "guide/window",
            "guide/stop",
            "guide/robots",
            "guide/several-robots",
            "guide/commands",
            "guide/driving",
            "guide/scripts",
            "guide/plots",
            "guide/loading-acts",
            "guide/quitting",
            "guide/files");

    private final JTextField search = new JTextField();
    private final transient List<JTable> tables = new ArrayList<>();
    private final JTabbedPane tabs = new JTabbedPane();

    /**
     * Creates the dialog, not yet shown.
     *
     * @param current the robot whose parameters are shown first
     */
    public HelpDialog(Window owner, List<Member> members, Optional<Member> current) {
        super(owner, TEXTS.get("help"));
        tabs.setName("helpTabs");
        tabs.addTab(
                TEXTS.get("commands"),
                scrolled("commands", file(TEXTS.get("commands.file"), TEXTS.get("commands.command"))));
        if (!members.isEmpty()) {
            tabs.addTab(TEXTS.get("parameters"), parameters(members, current));
        }
        tabs.addTab(TEXTS.get("keys"), scrolled("keys", file(TEXTS.get("keys.file"), TEXTS.get("keys.key"))));
        addPages(GUIDE, TEXTS.get("guide"));
        addPages(List.of("majic-script"), TEXTS.get("guide.script"));
        tabs.addChangeListener(change -> search());
        tabs.setPreferredSize(new Dimension(widthWithin(owner), UIScale.scale(480)));
        fill(content(), closing(TEXTS.get("close")));
        focusFirst(search);
    }

    /** Returns the width for the texts of most tables, as far as the screen has room for it. */
    private int widthWithin(Window owner) {
        GraphicsConfiguration screen = owner.getGraphicsConfiguration();
        int most = (screen == null ? owner.getSize() : screen.getBounds().getSize()).width;
        int texts = tables.stream().mapToInt(TableColumns::widthOf).max().orElse(0);
        int wanted =
                Math.max(UIScale.scale(LEAST_WIDTH), Math.min(texts + UIScale.scale(EDGES), UIScale.scale(MOST_WIDTH)));
        return Math.min(wanted, most - UIScale.scale(2 * EDGES));
    }

    private void addPages(List<String> names, String title) {
        tabs.addTab(title, new GuideView(names, title));
    }

    /** Selects the first page of the guide. */
    public void showGuide() {
        tabs.setSelectedIndex(tabs.indexOfTab(TEXTS.get("guide")));
    }

    /**
     * Shows a section of the guide; all of the guide is shown, whatever was searched for.
     *
     * @param section as in {@link majic.gui.kit.HelpTopic}
     */
    public void showSection(String section) {
        int tab = tabs.indexOfTab(TEXTS.get("guide"));
        ((GuideView) tabs.getComponentAt(tab)).scrollTo(section);
        search.setText("");
        tabs.setSelectedIndex(tab);
        search();
    }

    private JPanel content() {
        search.setName("helpSearch");
        search.getDocument().addDocumentListener(new TextChange(this::search));
        JPanel content = new JPanel(new MigLayout("insets 0, gap 8 8", "[][grow, fill]", "[][grow, fill]"));
        content.add(label(TEXTS.get("search"), search));
        content.add(search, "wrap");
        content.add(tabs, "spanx 2, grow");
        return content;
    }

    /** Shows only the rows, or the parts of a page, that contain the text. */
    private void search() {
        String wanted = search.getText().strip();
        RowFilter<TableModel, Integer> filter = RowFilter.regexFilter("(?iu)" + Pattern.quote(wanted));
        tables.forEach(table -> sorter(table).setRowFilter(filter));
        Component shown = tabs.getSelectedComponent();
        if (shown instanceof GuideView page) {
            page.search(wanted);
        }
    }

    @SuppressWarnings("unchecked")
    private static TableRowSorter<TableModel> sorter(JTable table) {
        return (TableRowSorter<TableModel>) table.getRowSorter();
    }

    private JPanel parameters(List<Member> members, Optional<Member> current) {
        MemberChoice choice = new MemberChoice(members, current);
        JScrollPane rows = scrolled("parameters", HelpTables.noParameters());
        JTable table = (JTable) rows.getViewport().getView();
        choice.addActionListener(event -> list(choice, table));
        list(choice, table);
        JPanel panel = new JPanel(new MigLayout("insets 8 0 0 0", "[][grow, fill]", "[][grow, fill]"));
        panel.add(label(TEXTS.get("robot"), choice));
        panel.add(choice, "grow 0, wmin 220, wrap");
        panel.add(rows, "spanx 2, grow");
        return panel;
    }

    /** Makes the rows in the background; shows them if the robot is still the chosen one then. */
    private void list(MemberChoice choice, JTable table) {
        Member member = choice.chosen();
        EventThread.background("listing parameters", () -> {
            TableModel rows = HelpTables.of(member);
            EventThread.later(() -> {
                if (choice.chosen() == member) {
                    show(table, rows);
                    search();
                }
            });
        });
    }

    private static TableModel file(String name, String left) {
        return HelpTables.file(name, left, TEXTS.get("effect"));
    }

    private JScrollPane scrolled(String key, TableModel model) {
        JTable table = new JTable();
        table.setName("help " + key);
        table.getAccessibleContext().setAccessibleName(TEXTS.get(key));
        table.setShowHorizontalLines(true);
        table.setAutoResizeMode(JTable.AUTO_RESIZE_LAST_COLUMN);
        table.getTableHeader().setReorderingAllowed(false);
        show(table, model);
        tables.add(table);
        return new JScrollPane(table);
    }

    private static void show(JTable table, TableModel model) {
        table.setModel(model);
        TableRowSorter<TableModel> sorter = new TableRowSorter<>(model);
        for (int column = 0; column < model.getColumnCount(); column++) {
            sorter.setSortable(column, false);
        }
        table.setRowSorter(sorter);
        TableColumns.fit(table);
    }
}
