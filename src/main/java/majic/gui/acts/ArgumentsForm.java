package majic.gui.acts;

import java.awt.BorderLayout;
import java.awt.Font;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import javax.swing.BorderFactory;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.SwingUtilities;
import majic.act.ActArgument;
import majic.bot.Value;
import majic.gui.kit.MajicDialog;
import majic.gui.kit.Mnemonics;
import majic.gui.kit.ScrolledPanel;
import majic.gui.kit.StyledLabel;
import majic.text.Texts;
import net.miginfocom.swing.MigLayout;

/** Asks for the values of an act's arguments; begins with the defaults. Invisible for an act without arguments. */
final class ArgumentsForm extends JPanel {
    private static final long serialVersionUID = 1L;
    private static final Texts TEXTS = Texts.of(ArgumentsForm.class);

    private final JPanel rows =
            new ScrolledPanel(new MigLayout("insets 0 0 0 6, gap 8 2", "[shrink 0][][grow, fill]", ""));
    private final transient Runnable changed;
    private transient List<ArgumentInput> inputs = List.of();

    /**
     * Creates an empty form.
     *
     * @param changed called when the user changes a value
     */
    ArgumentsForm(Runnable changed) {
        super(new BorderLayout(0, 6));
        this.changed = changed;
        JLabel title = new StyledLabel("argumentsTitle", TEXTS.get("arguments"), Font.BOLD, 0);
        JScrollPane scroll =
                new JScrollPane(rows, JScrollPane.VERTICAL_SCROLLBAR_AS_NEEDED, JScrollPane.HORIZONTAL_SCROLLBAR_NEVER);
        scroll.setBorder(BorderFactory.createEmptyBorder());
        add(title, BorderLayout.NORTH);
        add(scroll, BorderLayout.CENTER);
        setVisible(false);
    }

    /** Shows the arguments of another act, with their defaults. */
    void show(List<ActArgument> arguments) {
        rows.removeAll();
        inputs = arguments.stream().map(one -> new ArgumentInput(one, changed)).toList();
        inputs.forEach(this::addRow);
        setVisible(!inputs.isEmpty());
        revalidate();
        repaint();
        if (SwingUtilities.getWindowAncestor(this) != null) {
            Mnemonics.assign(SwingUtilities.getWindowAncestor(this));
        }
    }

    private void addRow(ArgumentInput input) {
        rows.add(MajicDialog.label(input.argument().name(), input.field()));
        rows.add(input.field());
        rows.add(new JLabel(input.argument().parameter().unit().symbol()), "wrap");
        rows.add(input.hint(), "skip 1, spanx 2, growx, wmin 0, gapbottom 6, wrap");
    }

    /** Returns whether all values are permitted. */
    boolean isComplete() {
        return inputs.stream().allMatch(ArgumentInput::isRight);
    }

    /** Returns the values by the names of the arguments; all are permitted. */
    Map<String, Value> values() {
        Map<String, Value> values = new LinkedHashMap<>();
        inputs.forEach(input -> values.put(input.argument().name(), input.value()));
        return values;
    }
}
