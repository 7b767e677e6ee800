package majic.gui.replay;

import java.awt.Component;
import java.util.List;
import java.util.function.DoubleConsumer;
import javax.swing.DefaultListCellRenderer;
import javax.swing.JList;
import javax.swing.KeyStroke;
import javax.swing.ListSelectionModel;
import majic.gui.kit.DoubleClick;
import majic.gui.kit.Palette;
import majic.log.Line;
import majic.panel.KeyAction;
import majic.recorder.RecordedLine;
import majic.text.Texts;

/**
 * The lines of the recorded session; the last one up to the position is selected. A double click or Enter on another
 * one continues there.
 */
final class ReplayLines extends JList<RecordedLine> {
    private static final long serialVersionUID = 1L;
    private static final Texts TEXTS = Texts.of(ReplayLines.class);

    private final transient List<RecordedLine> lines;

    /**
     * Creates the list.
     *
     * @param chosen receives the time of a line that the user has chosen, seconds
     */
    ReplayLines(List<RecordedLine> lines, DoubleConsumer chosen) {
        super(lines.toArray(new RecordedLine[0]));
        this.lines = lines;
        setName("replayLines");
        getAccessibleContext().setAccessibleName(TEXTS.get("lines"));
        setToolTipText(TEXTS.get("lines.hint"));
        setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
        setVisibleRowCount(5);
        setCellRenderer(new LineRenderer());
        setPrototypeCellValue(new RecordedLine(0, Line.Kind.ANSWER, "1 move 500: done (498 mm, 2.1 s)"));
        KeyAction.bind(this, WHEN_FOCUSED, KeyStroke.getKeyStroke("ENTER"), event -> choose(chosen));
        addMouseListener(new DoubleClick(() -> choose(chosen)));
    }

    private void choose(DoubleConsumer chosen) {
        RecordedLine line = getSelectedValue();
        if (line != null) {
            chosen.accept(line.seconds());
        }
    }

    /** Selects the last line up to a time. */
    void follow(double seconds) {
        int last = -1;
        for (int index = 0; index < lines.size() && lines.get(index).seconds() <= seconds + 0.05; index++) {
            last = index;
        }
        if (last < 0) {
            clearSelection();
        } else if (last != getSelectedIndex()) {
            setSelectedIndex(last);
            ensureIndexIsVisible(last);
        }
    }

    /** Shows time and text of a line, errors and alarms with a sign and in the colour of errors. */
    private static final class LineRenderer extends DefaultListCellRenderer {
        private static final long serialVersionUID = 1L;

        @Override
        public Component getListCellRendererComponent(
                JList<?> list, Object value, int index, boolean selected, boolean focused) {
            super.getListCellRendererComponent(list, value, index, selected, focused);
            if (value instanceof RecordedLine line) {
                String sign = switch (line.kind()) {
                    case COMMAND -> "> ";
                    case ALARM, ERROR, FAILURE -> "! ";
                    case ANSWER, NOTICE -> "  ";
                };
                setText(ReplayTimes.clock(line.seconds()) + "  " + sign + line.text());
                if (!selected && sign.equals("! ")) {
                    setForeground(Palette.error());
                } else if (!selected && sign.equals("> ")) {
                    setForeground(Palette.command());
                }
            }
            return this;
        }
    }
}
