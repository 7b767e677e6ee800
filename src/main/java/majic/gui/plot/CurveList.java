package majic.gui.plot;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Component;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.util.ArrayList;
import java.util.List;
import javax.swing.Icon;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.KeyStroke;
import javax.swing.SwingConstants;
import majic.gui.kit.ScrolledPanel;
import majic.panel.DrawingColors;
import majic.panel.KeyAction;
import majic.text.Texts;
import net.miginfocom.swing.MigLayout;

/**
 * The legend of a plot: for each curve its line, its name, the newest value, and a button that removes it. Must be used
 * on the event dispatch thread.
 */
final class CurveList extends ScrolledPanel {
    private static final long serialVersionUID = 1L;
    private static final Texts TEXTS = Texts.of(CurveList.class);

    private final transient PlotModel model;
    private transient List<Row> rows = List.of();

    /** The label that shows the newest value of a curve. */
    private record Row(Curve curve, JLabel value) {
        void update(double seconds) {
            String text = Curve.text(curve.quantity(), curve.points().at(seconds));
            if (!text.equals(value.getText())) {
                value.setText(text);
            }
        }
    }

    CurveList(PlotModel model) {
        super(new MigLayout("insets 8 10 8 6, gap 6 2, wrap 4, fillx", "[][grow, fill][right][]"));
        this.model = model;
        setName("curves");
        model.addListener(this::curvesChanged);
    }

    private void curvesChanged() {
        List<Curve> curves = model.curves();
        if (!curves.equals(rows.stream().map(Row::curve).toList())) {
            removeAll();
            List<Row> added = new ArrayList<>();
            curves.forEach(curve -> added.add(row(curve)));
            rows = added;
            revalidate();
            repaint();
        }
        update();
    }

    /** Shows the newest values of the time that is shown. */
    void update() {
        double seconds = model.time().to();
        rows.forEach(row -> row.update(seconds));
    }

    private Row row(Curve curve) {
        String label = curve.quantity().label();
        JLabel name = new JLabel(curve.name());
        name.setName("curve " + label);
        name.setToolTipText(curve.label());
        JLabel value = new JLabel("–", SwingConstants.TRAILING);
        value.setName("value " + label);
        add(new JLabel(new Line(curve.style())));
        add(name, "wmin 0");
        add(value);
        add(remover(curve));
        return new Row(curve, value);
    }

    private JButton remover(Curve curve) {
        String label = curve.quantity().label();
        JButton button = new JButton("×");
        button.setName("remove " + label);
        button.setToolTipText(TEXTS.get("remove"));
        button.getAccessibleContext().setAccessibleName(TEXTS.get("remove.curve", curve.label()));
        button.putClientProperty("JButton.buttonType", "toolBarButton");
        button.addActionListener(event -> model.remove(curve));
        KeyAction.bind(button, WHEN_FOCUSED, KeyStroke.getKeyStroke("DELETE"), event -> model.remove(curve));
        return button;
    }

    /** A piece of a curve's line. */
    private record Line(CurveStyle style) implements Icon {
        private static final int WIDTH = 26;
        private static final int HEIGHT = 12;

        @Override
        public void paintIcon(Component component, Graphics graphics, int x, int y) {
            Graphics2D pen = (Graphics2D) graphics.create();
            DrawingColors.prepare(pen);
            pen.setColor(style.color());
            pen.setStroke(style.stroke());
            int middle = y + getIconHeight() / 2;
            pen.drawLine(x + 1, middle, x + getIconWidth() - 2, middle);
            pen.dispose();
        }

        @Override
        public int getIconWidth() {
            return UIScale.scale(WIDTH);
        }

        @Override
        public int getIconHeight() {
            return UIScale.scale(HEIGHT);
        }
    }
}
