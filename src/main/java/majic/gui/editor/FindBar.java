package majic.gui.editor;

import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import majic.gui.kit.ClosesByEsc;
import majic.gui.kit.Mnemonics;
import majic.gui.kit.Palette;
import majic.panel.KeyAction;
import majic.text.Texts;
import net.miginfocom.swing.MigLayout;
import org.fife.ui.rsyntaxtextarea.RSyntaxTextArea;
import org.fife.ui.rtextarea.SearchContext;
import org.fife.ui.rtextarea.SearchEngine;
import org.fife.ui.rtextarea.SearchResult;

/** Finds a text in a script and marks all its places. Hidden until it is asked for; Esc hides it. */
final class FindBar extends JPanel implements ClosesByEsc {
    private static final long serialVersionUID = 1L;
    private static final Texts TEXTS = Texts.of(FindBar.class);

    private final RSyntaxTextArea area;
    private final JTextField field = new JTextField(24);
    private final JLabel count = new JLabel();

    FindBar(RSyntaxTextArea area) {
        super(new MigLayout("insets 4 10 4 8, gap 6", "[][][][][grow, fill][]"));
        this.area = area;
        JLabel label = new JLabel(TEXTS.get("findBar"));
        label.setLabelFor(field);
        field.setName("find");
        field.addActionListener(event -> find(true));
        KeyAction.bind(field, WHEN_FOCUSED, KeyStroke.getKeyStroke("shift ENTER"), event -> find(false));
        count.setName("findCount");
        add(label);
        add(field);
        add(button("findPrevious", TEXTS.get("findBar.previous"), () -> find(false)));
        add(button("findNext", TEXTS.get("findBar.next"), () -> find(true)));
        add(count, "wmin 0");
        add(button("findClose", TEXTS.get("findBar.close"), this::close));
        KeyAction.bind(this, WHEN_ANCESTOR_OF_FOCUSED_COMPONENT, KeyStroke.getKeyStroke("ESCAPE"), event -> close());
        Mnemonics.assign(this);
        setVisible(false);
    }

    private static JButton button(String name, String text, Runnable action) {
        JButton button = new JButton(text);
        button.setName(name);
        button.addActionListener(event -> action.run());
        return button;
    }

    /** Shows the bar with the text that is selected, ready for another one. */
    void open() {
        String selected = area.getSelectedText();
        if (selected != null && selected.indexOf('\n') < 0) {
            field.setText(selected);
        }
        setVisible(true);
        field.selectAll();
        field.requestFocusInWindow();
    }

    private void close() {
        setVisible(false);
        SearchEngine.markAll(area, new SearchContext());
        area.requestFocusInWindow();
    }

    @Override
    public boolean hasToClose() {
        return isVisible();
    }

    private void find(boolean forward) {
        SearchContext context = new SearchContext(field.getText());
        context.setSearchForward(forward);
        context.setSearchWrap(true);
        SearchResult result = SearchEngine.find(area, context);
        boolean wrong = !result.wasFound() && !field.getText().isEmpty();
        count.setForeground(wrong ? Palette.error() : Palette.text());
        count.setText(
                field.getText().isEmpty()
                        ? ""
                        : wrong ? TEXTS.get("findBar.notFound") : TEXTS.get("findBar.found", result.getMarkedCount()));
    }
}
