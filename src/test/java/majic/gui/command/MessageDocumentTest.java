package majic.gui.command;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Color;
import java.time.LocalTime;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.swing.text.AttributeSet;
import javax.swing.text.BadLocationException;
import javax.swing.text.StyleConstants;
import majic.gui.kit.Palette;
import majic.log.Line;
import org.junit.jupiter.api.Test;

class MessageDocumentTest {
    private final MessageDocument document = new MessageDocument(false);

    @Test
    void kindsDifferBySignAndNotByColourAlone() throws BadLocationException {
        document.append(messages(
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
        document.append(messages(new Line(Line.Kind.ERROR, "one"), new Line(Line.Kind.ANSWER, "two")));
        StyleConstants.setForeground(document.getStyle(Line.Kind.ERROR.name()), Color.PINK);
        assertThat(colorAt(1)).isEqualTo(Color.PINK);
        assertThat(colorAt(document.getLength() - 1)).isEqualTo(Palette.text());
    }

    @Test
    void anAlarmIsShownOnTheColourOfErrors() {
        document.append(messages(new Line(Line.Kind.ALARM, "1: connection lost")));
        AttributeSet look = document.getCharacterElement(3).getAttributes();
        assertThat(StyleConstants.getBackground(look)).isEqualTo(Palette.error());
        assertThat(StyleConstants.getForeground(look)).isEqualTo(Palette.paper());
        assertThat(StyleConstants.isBold(look)).isTrue();
    }

    @Test
    void eachLineBeginsWithItsTimeIfWanted() throws BadLocationException {
        MessageDocument timed = new MessageDocument(true);
        timed.append(messages(new Line(Line.Kind.ANSWER, "one"), new Line(Line.Kind.NOTICE, "two")));
        assertThat(timed.getText(0, timed.getLength())).isEqualTo("12:30:05   one\n12:30:05 * two");
    }

    @Test
    void aPlaceOfTheTextLeadsToItsMessage() {
        document.append(answers(1, MessageDocument.MOST_LINES + 3));
        assertThat(document.messageAt(3).line().text()).isEqualTo("line 4");
        assertThat(document.messageAt(document.getLength()).line().text()).isEqualTo("line 2003");
    }

    private static List<Message> messages(Line... lines) {
        return Stream.of(lines)
                .map(line -> new Message(LocalTime.of(12, 30, 5), line))
                .toList();
    }

    private static List<Message> answers(int first, int last) {
        return IntStream.rangeClosed(first, last)
                .mapToObj(number -> new Line(Line.Kind.ANSWER, "line " + number))
                .flatMap(line -> messages(line).stream())
                .toList();
    }

    private Color colorAt(int offset) {
        return StyleConstants.getForeground(document.getCharacterElement(offset).getAttributes());
    }

    private String text() throws BadLocationException {
        return document.getText(0, document.getLength());
    }
}
