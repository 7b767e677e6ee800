package majic.gui.plot;

import java.awt.Component;
import java.awt.Window;
import java.util.List;
import java.util.function.Function;
import java.util.stream.Stream;
import javax.swing.DefaultListCellRenderer;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JPanel;
import javax.swing.JTextField;
import majic.gui.kit.MajicDialog;
import majic.gui.kit.Paragraph;
import majic.gui.plot.data.Computation.Operation;
import majic.text.Texts;
import net.miginfocom.swing.MigLayout;

/** Adds a curve to a plot that is computed from one or two of its curves. */
final class ComputeCurveDialog extends MajicDialog {
    private static final long serialVersionUID = 1L;
    private static final Texts TEXTS = Texts.of(ComputeCurveDialog.class);

    private final transient PlotModel model;
    private final JComboBox<Operation> operation = new JComboBox<>(Operation.values());
    private final JComboBox<Curve> first;
    private final JComboBox<Curve> second;
    private final JTextField number = new JTextField("2", 8);
    private final JLabel firstLabel;
    private final JLabel secondLabel;
    private final JLabel numberLabel;
    private final Paragraph problem = new Paragraph("computeProblem", 1, 36);

    /**
     * Creates the dialog.
     *
     * @param model has a curve at least
     */
    ComputeCurveDialog(Window owner, PlotModel model) {
        super(owner, TEXTS.get("compute"));
        this.model = model;
        Curve[] curves = operands(model).toArray(Curve[]::new);
        first = curves("firstCurve", curves);
        second = curves("secondCurve", curves);
        second.setSelectedIndex(curves.length - 1);
        operation.setName("operation");
        operation.setRenderer(new Words<>(ComputeCurveDialog::words));
        operation.addActionListener(event -> showNeeded());
        number.setName("number");
        firstLabel = label(TEXTS.get("first"), first);
        secondLabel = label(TEXTS.get("second"), second);
        numberLabel = label(TEXTS.get("factor"), number);
        JPanel content = new JPanel(new MigLayout("insets 0, gap 8 8, wrap 2", "[][grow, fill]"));
        content.add(label(TEXTS.get("operation"), operation));
        content.add(operation);
        content.add(firstLabel);
        content.add(first);
        content.add(secondLabel);
        content.add(second);
        content.add(numberLabel);
        content.add(number);
        content.add(problem, "spanx 2, growx, wmin 0");
        JButton add = button(TEXTS.get("addComputed"), this::add);
        fill(content, add, closing(TEXTS.get("close")));
        showNeeded();
    }

    /** Returns the curves of a plot that others can be computed from: numbers, no switches. */
    static Stream<Curve> operands(PlotModel model) {
        return model.curves().stream().filter(curve -> !curve.quantity().switched());
    }

    private static JComboBox<Curve> curves(String name, Curve[] curves) {
        JComboBox<Curve> box = new JComboBox<>(curves);
        box.setName(name);
        box.setRenderer(new Words<>(Curve::label));
        return box;
    }

    private static String words(Operation operation) {
        return TEXTS.get(
                switch (operation) {
                    case SUM -> "sum";
                    case DIFFERENCE -> "difference";
                    case SCALE -> "scale";
                    case DERIVATIVE -> "derivative";
                    case SMOOTHED -> "smoothed";
                });
    }

    private Operation chosen() {
        return (Operation) operation.getSelectedItem();
    }

    /** Disables what the operation does not need, so that nothing moves. */
    private void showNeeded() {
        Operation chosen = chosen();
        second.setEnabled(chosen.hasTwo());
        secondLabel.setEnabled(chosen.hasTwo());
        number.setEnabled(chosen.hasNumber());
        numberLabel.setEnabled(chosen.hasNumber());
        numberLabel.setText(TEXTS.get(chosen == Operation.SMOOTHED ? "seconds" : "factor"));
        problem.show("", false);
    }

    private void add() {
        Operation chosen = chosen();
        double value = 0;
        try {
            value = chosen.hasNumber() ? Double.parseDouble(number.getText().strip()) : 0;
        } catch (NumberFormatException e) {
            value = Double.NaN;
        }
        if (!Double.isFinite(value) || (chosen == Operation.SMOOTHED && value <= 0)) {
            problem.show(TEXTS.get(chosen == Operation.SMOOTHED ? "notSeconds" : "notFactor"), true);
            number.requestFocusInWindow();
            return;
        }
        List<Curve> operands = chosen.hasTwo()
                ? List.of(first.getItemAt(first.getSelectedIndex()), second.getItemAt(second.getSelectedIndex()))
                : List.of(first.getItemAt(first.getSelectedIndex()));
        model.add(Curve.computed(chosen, operands, value));
        dispose();
    }

    /** Shows the entries of a box by words. */
    private static final class Words<T> extends DefaultListCellRenderer {
        private static final long serialVersionUID = 1L;

        private final transient Function<T, String> words;

        Words(Function<T, String> words) {
            this.words = words;
        }

        @Override
        @SuppressWarnings("unchecked")
        public Component getListCellRendererComponent(
                JList<?> list, Object value, int index, boolean selected, boolean focused) {
            return super.getListCellRendererComponent(list, words.apply((T) value), index, selected, focused);
        }
    }
}
