package majic.gui.command;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Color;
import java.util.List;
import java.util.stream.IntStream;
import javax.swing.text.AttributeSet;
import javax.swing.text.BadLocationException;
import javax.swing.text.StyleConstants;
import majic.gui.kit.Palette;
import majic.log.Line;
import org.junit.jupiter.api.Test;

class MessageDocumentTest {
    private final MessageDocument document = new MessageDocument();

    @Test
    void kindsDifferBySignAndNotByColourAlone() throws BadLocationException {
        document.append(List.of(
                new Line(Line.Kind.COMMAND, "1 move 5"),
                new Line(Line.Kind.ANSWER, "1 move 5: done"),
                new Line(Line.Kind.NOTICE, "1: motors are on"),
                new Line(Line.Kind.FAILURE, "1 move 5: failed: blocked"),
                new Line(Line.Kind.ALARM, "1: connection lost"),
                new Line(Line.Kind.ERROR, "no such robot")));
        assertThat(text())
                .isEqualTo("> 1 move 5\n  1 move 5: done\n* 1: motors are on\n! 1 move 5: failed: blocked\n"
                        + "\u203c 1: connection lost\n! no such robot");
    }

    @Test
    void theOldestLinesAreForgotten() throws BadLocationException {
        document.append(answers(1, 10));
        document.append(answers(11, MessageDocument.MOST_LINES + 7));
        assertThat(text().lines()).hasSize(MessageDocument.MOST_LINES);
        assertThat(text()).startsWith("  line 8\n").endsWith("line 2007");
    }

    @Test
    void ofAFloodOnlyTheNewestLinesAreTaken() throws BadLocationException {
        document.append(answers(1, MessageDocument.MOST_LINES + 7));
        assertThat(text().lines()).hasSize(MessageDocument.MOST_LINES);
        assertThat(text()).startsWith("  line 8\n").endsWith("line 2007");
    }

    @Test
    void linesThatAreThereFollowAChangeOfTheLook() {
        document.append(List.of(new Line(Line.Kind.ERROR, "one"), new Line(Line.Kind.ANSWER, "two")));
        StyleConstants.setForeground(document.getStyle(Line.Kind.ERROR.name()), Color.PINK);
        assertThat(colorAt(1)).isEqualTo(Color.PINK);
        assertThat(colorAt(document.getLength() - 1)).isEqualTo(Palette.text());
    }

    @Test
    void anAlarmIsShownOnTheColourOfErrors() {
        document.append(List.of(new Line(Line.Kind.ALARM, "1: connection lost")));
        AttributeSet look = document.getCharacterElement(3).getAttributes();
        assertThat(StyleConstants.getBackground(look)).isEqualTo(Palette.error());
        assertThat(StyleConstants.getForeground(look)).isEqualTo(Palette.paper());
        assertThat(StyleConstants.isBold(look)).isTrue();
    }

    private static List<Line> answers(int first, int last) {
        return IntStream.rangeClosed(first, last)
                .mapToObj(number -> new Line(Line.Kind.ANSWER, "line " + number))
                .toList();
    }

    private Color colorAt(int offset) {
        return StyleConstants.getForeground(document.getCharacterElement(offset).getAttributes());
    }

    private String text() throws BadLocationException {
        return document.getText(0, document.getLength());
    }
}
