package majic.gui.editor;

import java.awt.Color;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.Font;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JPanel;
import javax.swing.ListCellRenderer;
import majic.gui.kit.Palette;
import majic.gui.kit.PlainLabel;
import majic.script.help.Completion;
import net.miginfocom.swing.MigLayout;
import org.fife.ui.autocomplete.AbstractCompletion;
import org.fife.ui.autocomplete.CompletionProvider;

/** Shows a completion: the word, what it takes, and its explanation. */
final class CompletionCell extends JPanel implements ListCellRenderer<Object> {
    private static final long serialVersionUID = 1L;

    private final JLabel word = new PlainLabel("completionWord", " ");
    private final JLabel values = new PlainLabel("completionValues", "");
    private final JLabel explanation = new PlainLabel("completionExplanation", "");

    CompletionCell() {
        super(new MigLayout("insets 2 6 2 6, gap 10", "[140!][120!][grow, fill]"));
        add(word, "wmin 0, wmax 140");
        add(values, "wmin 0, wmax 120");
        add(explanation, "wmin 0");
    }

    /** Is never wider than the list, so that the list needs no bar. */
    @Override
    public Dimension getPreferredSize() {
        return new Dimension(0, super.getPreferredSize().height);
    }

    /** A completion in the list. */
    static final class Entry extends AbstractCompletion {
        private final Completion completion;

        Entry(CompletionProvider provider, Completion completion) {
            super(provider);
            this.completion = completion;
        }

        @Override
        public String getReplacementText() {
            return completion.text();
        }

        @Override
        public String getSummary() {
            return completion.explanation();
        }
    }

    @Override
    public Component getListCellRendererComponent(
            JList<?> list, Object value, int index, boolean selected, boolean focused) {
        Completion completion = ((Entry) value).completion;
        word.setText(completion.text());
        values.setText(completion.values());
        explanation.setText(completion.explanation());
        Color text = selected ? list.getSelectionForeground() : Palette.text();
        word.setFont(list.getFont().deriveFont(Font.BOLD));
        word.setForeground(text);
        values.setForeground(text);
        explanation.setForeground(selected ? text : Palette.faint());
        setBackground(selected ? list.getSelectionBackground() : list.getBackground());
        return this;
    }
}
