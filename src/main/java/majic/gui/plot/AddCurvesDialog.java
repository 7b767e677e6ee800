package majic.gui.plot;

import com.formdev.flatlaf.util.UIScale;
import java.awt.BorderLayout;
import java.awt.Color;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.Font;
import java.awt.Window;
import java.util.List;
import java.util.Locale;
import javax.swing.BorderFactory;
import javax.swing.DefaultListModel;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import javax.swing.ListCellRenderer;
import majic.bot.Parameter;
import majic.gui.kit.DoubleClick;
import majic.gui.kit.MajicDialog;
import majic.gui.kit.StyledLabel;
import majic.gui.kit.TextChange;
import majic.gui.plot.data.PlotSource;
import majic.gui.plot.data.Quantity;
import majic.panel.KeyAction;
import majic.text.Texts;
import net.miginfocom.swing.MigLayout;

/** Chooses parameters of robots whose curves are added to a plot. */
final class AddCurvesDialog extends MajicDialog {
    private static final long serialVersionUID = 1L;
    private static final Texts TEXTS = Texts.of(AddCurvesDialog.class);

    private final transient PlotModel model;
    private final transient List<Entry> all;
    private final DefaultListModel<Entry> shown = new DefaultListModel<>();
    private final JList<Entry> list = new JList<>(shown);
    private final JTextField filter = new JTextField();
    private final JButton add = button(TEXTS.get("addSelected"), this::addSelected);

    /** A parameter of a robot. */
    private record Entry(PlotSource.Robot robot, Parameter parameter) {
        @Override
        public String toString() {
            return robot.number() + " " + parameter.name() + Quantity.unitText(parameter.unit());
        }

        boolean matches(String words) {
            String text = (this + " " + robot.label() + " " + parameter.help()).toLowerCase(Locale.ROOT);
            return List.of(words.toLowerCase(Locale.ROOT).strip().split("\\s+")).stream()
                    .allMatch(text::contains);
        }
    }

    AddCurvesDialog(Window owner, PlotModel model) {
        super(owner, TEXTS.get("addCurves"));
        this.model = model;
        this.all = model.source().robots().stream()
                .flatMap(robot -> robot.parameters().stream().map(parameter -> new Entry(robot, parameter)))
                .toList();
        filter.setName("curveFilter");
        filter.putClientProperty("JTextField.placeholderText", TEXTS.get("find.hint"));
        filter.getDocument().addDocumentListener(new TextChange(this::filter));
        list.setName("parameters");
        Cell cell = new Cell();
        list.setCellRenderer(cell);
        list.setFixedCellHeight(cell.getPreferredSize().height);
        list.setFixedCellWidth(1);
        list.addListSelectionListener(event -> add.setEnabled(!list.isSelectionEmpty()));
        list.addMouseListener(new DoubleClick(add::doClick));
        KeyAction.bind(
                filter, JComponent.WHEN_FOCUSED, KeyStroke.getKeyStroke("DOWN"), event -> list.requestFocusInWindow());
        fill(content(), add, closing(TEXTS.get("close")));
        filter();
    }

    private JPanel content() {
        JPanel content = new JPanel(new MigLayout("insets 0, gap 8 8, wrap 2", "[][grow, fill]", "[][grow, fill][]"));
        JScrollPane scroll =
                new JScrollPane(list, JScrollPane.VERTICAL_SCROLLBAR_ALWAYS, JScrollPane.HORIZONTAL_SCROLLBAR_NEVER);
        scroll.setPreferredSize(new Dimension(UIScale.scale(560), UIScale.scale(320)));
        list.getAccessibleContext().setAccessibleName(TEXTS.get("parameters"));
        content.add(label(TEXTS.get("find"), filter));
        content.add(filter);
        content.add(scroll, "spanx 2, grow");
        content.add(new JLabel(TEXTS.get("several")), "spanx 2");
        return content;
    }

    private void filter() {
        shown.clear();
        shown.addAll(
                all.stream().filter(entry -> entry.matches(filter.getText())).toList());
        if (!shown.isEmpty()) {
            list.setSelectedIndex(0);
        }
        add.setEnabled(!shown.isEmpty());
    }

    private void addSelected() {
        model.add(list.getSelectedValuesList().stream()
                .flatMap(entry -> model
                        .source()
                        .quantities(entry.robot().number(), entry.parameter().name())
                        .stream())
                .toList());
        dispose();
    }

    /**
     * Shows the explanation behind the name. All rows have one height, so that the list asks for the visible ones only.
     */
    private static final class Cell extends JPanel implements ListCellRenderer<Entry> {
        private static final long serialVersionUID = 1L;

        private final JLabel name = new StyledLabel("parameter", " ", Font.BOLD, 0);
        private final JLabel help = new JLabel(" ");

        Cell() {
            super(new BorderLayout(UIScale.scale(8), 0));
            setBorder(BorderFactory.createEmptyBorder(UIScale.scale(1), UIScale.scale(5), UIScale.scale(1), 0));
            add(name, BorderLayout.WEST);
            add(help, BorderLayout.CENTER);
        }

        @Override
        public Component getListCellRendererComponent(
                JList<? extends Entry> list, Entry entry, int index, boolean selected, boolean focused) {
            setBackground(selected ? list.getSelectionBackground() : list.getBackground());
            Color text = selected ? list.getSelectionForeground() : list.getForeground();
            name.setForeground(text);
            help.setForeground(text);
            name.setText(entry.toString());
            help.setText(entry.parameter().help());
            getAccessibleContext()
                    .setAccessibleName(entry + " " + entry.parameter().help());
            return this;
        }
    }
}
