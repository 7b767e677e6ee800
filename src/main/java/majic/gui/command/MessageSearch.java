package majic.gui.command;

import java.awt.Graphics;
import java.awt.Rectangle;
import java.awt.Shape;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import javax.swing.text.BadLocationException;
import javax.swing.text.DefaultHighlighter;
import javax.swing.text.Document;
import javax.swing.text.Highlighter;
import javax.swing.text.JTextComponent;
import javax.swing.text.Position;
import javax.swing.text.View;
import majic.gui.kit.Palette;
import majic.text.Texts;

/**
 * Finds a text in the messages, in any case, marks every place, and selects one after the other. Must be used on the
 * event dispatch thread.
 */
final class MessageSearch {
    private static final Texts TEXTS = Texts.of(MessageSearch.class);
    private static final int MOST_MARKS = 500;

    private final MessageArea area;
    private final List<Object> marks = new ArrayList<>();
    private List<MatchResult> places = List.of();
    private String sought = "";
    private int present = -1;

    MessageSearch(MessageArea area) {
        this.area = area;
    }

    /** Finds a text; an empty one removes the marks. Selects nothing. */
    void find(String part) {
        sought = part;
        present = -1;
        repeat();
    }

    /** Finds the text again after the messages have changed. */
    void repeat() {
        if (sought.isEmpty() && marks.isEmpty()) {
            return;
        }
        places = places();
        present = Math.min(present, places.size() - 1);
        Highlighter highlighter = area.text().getHighlighter();
        marks.forEach(highlighter::removeHighlight);
        marks.clear();
        try {
            for (MatchResult place : places.subList(Math.max(0, places.size() - MOST_MARKS), places.size())) {
                marks.add(highlighter.addHighlight(place.start(), place.end(), new Mark()));
            }
        } catch (BadLocationException e) {
            throw new IllegalStateException("the places are in the text", e);
        }
    }

    private List<MatchResult> places() {
        Document document = area.text().getDocument();
        try {
            String all = document.getText(0, document.getLength());
            return sought.isEmpty()
                    ? List.of()
                    : Pattern.compile(Pattern.quote(sought), Pattern.CASE_INSENSITIVE | Pattern.UNICODE_CASE)
                            .matcher(all)
                            .results()
                            .toList();
        } catch (BadLocationException e) {
            throw new IllegalStateException("the text is all there", e);
        }
    }

    /**
     * Selects another place and scrolls to it: from the newest one to older ones, and on from the other end.
     *
     * @param step -1 for the previous place, 1 for the next
     */
    void move(int step) {
        if (places.isEmpty()) {
            return;
        }
        boolean first = present < 0;
        present = first ? places.size() - 1 : Math.floorMod(present + step, places.size());
        MatchResult place = places.get(present);
        MessageText text = area.text();
        text.select(place.start(), place.end());
        text.getCaret().setSelectionVisible(true);
        try {
            Rectangle seen = text.modelToView2D(place.start()).getBounds();
            seen.grow(0, 2 * seen.height);
            text.scrollRectToVisible(seen);
        } catch (BadLocationException e) {
            throw new IllegalStateException("the place is in the text", e);
        }
    }

    /** Returns the number of places, or which of them is selected: {@code 3 of 17}. */
    String count() {
        if (sought.isEmpty()) {
            return "";
        }
        return present < 0 ? TEXTS.get("found", places.size()) : TEXTS.get("found.place", present + 1, places.size());
    }

    /** Draws a frame, which leaves the colours of a message readable. */
    private static final class Mark extends DefaultHighlighter.DefaultHighlightPainter {
        Mark() {
            super(null);
        }

        @Override
        public Shape paintLayer(Graphics graphics, int from, int to, Shape bounds, JTextComponent text, View view) {
            try {
                Rectangle area = view.modelToView(from, Position.Bias.Forward, to, Position.Bias.Backward, bounds)
                        .getBounds();
                graphics.setColor(Palette.command());
                graphics.drawRect(area.x, area.y, area.width - 1, area.height - 1);
                graphics.drawRect(area.x + 1, area.y + 1, area.width - 3, area.height - 3);
                return area;
            } catch (BadLocationException e) {
                throw new IllegalStateException("the view shows the place", e);
            }
        }
    }
}
