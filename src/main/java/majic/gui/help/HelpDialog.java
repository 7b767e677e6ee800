package majic.gui.help;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.GraphicsConfiguration;
import java.awt.Window;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
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
    private static final int WIDTH = 920;
    private static final int LEAST_WIDTH = 400;
    private static final int LEAST_HEIGHT = 220;

    /** Room for the borders of the dialog on one side, pixels. */
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
        tabs.addTab(TEXTS.get("commands"), file("commands", TEXTS.get("commands.file"), TEXTS.get("commands.command")));
        if (!members.isEmpty()) {
            tabs.addTab(TEXTS.get("parameters"), parameters(members, current));
        }
        tabs.addTab(TEXTS.get("keys"), file("keys", TEXTS.get("keys.file"), TEXTS.get("keys.key")));
        addPages(GUIDE, TEXTS.get("guide"));
        addPages(List.of("majic-script"), TEXTS.get("guide.script"));
        tabs.addChangeListener(change -> search());
        tabs.setPreferredSize(new Dimension(widthWithin(owner), UIScale.scale(480)));
        canShrinkTo(LEAST_WIDTH, LEAST_HEIGHT);
        fill(content(), closing(TEXTS.get("close")));
        focusFirst(search);
    }

    /** Returns the width for the texts of most tables, as far as the screen has room for it. */
    private static int widthWithin(Window owner) {
        GraphicsConfiguration screen = owner.getGraphicsConfiguration();
        int most = (screen == null ? owner.getSize() : screen.getBounds().getSize()).width;
        return Math.min(UIScale.scale(WIDTH), most - UIScale.scale(2 * EDGES));
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
        String wanted = wanted();
        tables.forEach(table -> filter(table, wanted));
        Component shown = tabs.getSelectedComponent();
        if (shown instanceof GuideView page) {
            page.search(wanted);
        }
    }

    private String wanted() {
        return search.getText().strip();
    }

    @SuppressWarnings("unchecked")
    private static void filter(JTable table, String wanted) {
        ((TableRowSorter<TableModel>) table.getRowSorter())
                .setRowFilter(RowFilter.regexFilter("(?iu)" + Pattern.quote(wanted)));
    }

    private JPanel parameters(List<Member> members, Optional<Member> current) {
        MemberChoice choice = new MemberChoice(members, current);
        JTable table = table("parameters");
        choice.addActionListener(event -> list(choice, table));
        list(choice, table);
        JPanel panel = new JPanel(new MigLayout("insets 8 0 0 0", "[][grow, fill]", "[][grow, fill]"));
        panel.add(label(TEXTS.get("robot"), choice));
        panel.add(choice, "grow 0, wmin 220, wrap");
        panel.add(new JScrollPane(table), "spanx 2, grow");
        return panel;
    }

    private void list(MemberChoice choice, JTable table) {
        Member member = choice.chosen();
        fill(table, () -> HelpTables.of(member), () -> choice.chosen() == member);
    }

    private JScrollPane file(String name, String file, String left) {
        JTable table = table(name);
        fill(table, () -> HelpTables.file(file, left, TEXTS.get("effect")), () -> true);
        return new JScrollPane(table);
    }

    /** Creates a table without rows. */
    private JTable table(String key) {
        JTable table = new JTable();
        table.setName("help " + key);
        table.getAccessibleContext().setAccessibleName(TEXTS.get(key));
        table.setShowHorizontalLines(true);
        table.setAutoResizeMode(JTable.AUTO_RESIZE_LAST_COLUMN);
        table.getTableHeader().setReorderingAllowed(false);
        table.setRowSorter(new TableRowSorter<>(table.getModel()));
        tables.add(table);
        return table;
    }

    /** Makes the rows in the background; shows them in a piece of their own if they are still wanted then. */
    private void fill(JTable table, Supplier<TableModel> rows, BooleanSupplier isWanted) {
        EventThread.background("listing " + table.getName(), () -> {
            TableModel made = rows.get();
            EventThread.later(() -> EventThread.piece(() -> {
                if (isWanted.getAsBoolean()) {
                    show(table, made);
                    filter(table, wanted());
                }
            }));
        });
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
