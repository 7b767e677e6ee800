package majic.gui.command;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Point;
import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;
import java.util.Optional;
import java.util.stream.IntStream;
import javax.swing.JButton;
import javax.swing.JScrollBar;
import javax.swing.JTextPane;
import javax.swing.text.BadLocationException;
import javax.swing.text.Element;
import majic.gui.TestWindow;
import majic.gui.kit.Palette;
import majic.log.Line;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

class MessagesWindowTest {
    @AutoClose
    private final TestWindow window = TestWindow.open();

    @Test
    void theNewestLineStaysInSightWhenTheWindowShrinks() {
        MessageArea area = window.find("messageArea", MessageArea.class);
        IntStream.range(0, 60).forEach(index -> area.line(new Line(Line.Kind.NOTICE, "line " + index)));
        window.await("the newest line", this::isAtEnd);
        window.run(() -> window.frame.setSize(720, 540));
        window.await("a shorter message area", () -> bar().getVisibleAmount() < 140);
        window.await("the newest line", this::isAtEnd);
    }

    @Test
    void whileTheAreaIsScrolledUpAMarkerCountsTheNewLinesAndAClickGoesToThem() {
        MessageArea area = scrolledUp();
        assertThat(window.isShowing("newMessages")).isFalse();
        area.line(new Line(Line.Kind.NOTICE, "one more"));
        area.line(new Line(Line.Kind.NOTICE, "and another"));
        window.await("the marker", () -> window.isShowing("newMessages"));
        assertThat(window.text("newMessages")).contains("New lines: 2");
        area.line(new Line(Line.Kind.ALARM, "1: connection lost"));
        window.await("the alarm", () -> window.text("newMessages").contains("alarm: 3"));
        JButton marker = window.find("newMessages", JButton.class);
        assertThat(marker.getBackground()).isEqualTo(Palette.error());
        assertThat(marker.isFocusable()).isTrue();
        window.push("newMessages");
        window.await("the newest line", this::isAtEnd);
        window.await("the marker to go", () -> !window.isShowing("newMessages"));
    }

    @Test
    void aCommandGoesToTheNewestLine() {
        scrolledUp();
        window.command("bots");
        window.await("the newest line", this::isAtEnd);
        assertThat(window.isShowing("newMessages")).isFalse();
    }

    private MessageArea scrolledUp() {
        MessageArea area = window.find("messageArea", MessageArea.class);
        IntStream.range(0, 60).forEach(index -> area.line(new Line(Line.Kind.NOTICE, "line " + index)));
        window.awaitMessage("line 59");
        window.await("the newest line", this::isAtEnd);
        window.run(() -> bar().setValue(0));
        return area;
    }

    @Test
    void aClosedWindowReceivesNoMoreLinesOfTheSession() {
        MessageArea area = window.find("messageArea", MessageArea.class);
        JTextPane messages = window.find("messages", JTextPane.class);
        window.run(window.frame::dispose);

        window.session.alarm("after the end");
        window.session.flush();
        area.line(new Line(Line.Kind.NOTICE, "the next line"));

        window.await("the next line", () -> messages.getText().contains("the next line"));
        assertThat(messages.getText()).doesNotContain("after the end");
    }

    @Test
    void aLostConnectionAndAStopThatFailedAreAlarms() {
        window.add("one").loseLink();
        window.awaitMessage("\u203c 1: connection lost");
        window.command("1 stop");
        window.awaitMessage("\u203c 1 stop: failed");
    }

    @Test
    void anAlarmIsPaintedInReversedColours() {
        MessageArea area = window.find("messageArea", MessageArea.class);
        area.line(new Line(Line.Kind.ALARM, "1: connection lost"));
        window.awaitMessage("connection lost");
        window.run(() -> {
            BufferedImage picture = new BufferedImage(400, 60, BufferedImage.TYPE_INT_RGB);
            area.getViewport().getView().paint(picture.createGraphics());
            long red = IntStream.range(0, 400 * 60)
                    .filter(pixel -> picture.getRGB(pixel % 400, pixel / 400)
                            == Palette.error().getRGB())
                    .count();
            assertThat(red).as("pixels in the colour of alarms").isGreaterThan(1000);
        });
    }

    @Test
    void aFailedCommandHasTheSignOfErrors() {
        window.add("blocked");
        window.command("1 move 5");
        window.awaitMessage("! 1 move 5: failed: something is in the way");
    }

    @Test
    void aLongWordIsBroken() {
        MessageArea area = window.find("messageArea", MessageArea.class);
        area.line(new Line(Line.Kind.NOTICE, "/home/" + "x".repeat(900)));
        window.awaitMessage("xxx");
        window.run(() -> assertThat(area.getHorizontalScrollBar().isVisible()).isFalse());
        window.run(() -> assertThat(area.getViewport().getView().getWidth())
                .isLessThanOrEqualTo(area.getViewport().getWidth()));
        window.await("the newest line", this::isBroken);
    }

    @Test
    void theAreaStaysWhereItWasScrolledAlthoughTheOldestLinesAreRemoved() {
        MessageArea area = window.find("messageArea", MessageArea.class);
        add(area, 0, 2000);
        window.await("the lines", () -> window.text("messages").endsWith("line 1999"));
        window.await("the newest line", this::isAtEnd);
        window.run(() -> bar().setValue(bar().getMaximum() / 2));
        String before = firstInView();
        add(area, 2000, 2300);
        window.await("the lines", () -> window.text("messages").endsWith("line 2299"));
        assertThat(firstInView()).isEqualTo(before);
    }

    @Test
    void anAreaThatIsScrolledUpRightAfterItsSizeHasChangedStaysThere() {
        MessageArea area = window.find("messageArea", MessageArea.class);
        add(area, 0, 60);
        window.awaitMessage("line 59");
        window.await("the newest line", this::isAtEnd);
        window.run(() -> {
            window.frame.setSize(720, 540);
            window.frame.validate();
            bar().setValue(0);
        });
        assertThat(bar().getValue()).isZero();
    }

    @Test
    void aFoundTextIsCountedAndSelectedFromTheNewestOn() {
        MessageArea area = window.find("messageArea", MessageArea.class);
        add(area, 0, 30);
        window.awaitMessage("line 29");
        window.focus("commandLine");
        window.pressWithCtrl(KeyEvent.VK_F);
        window.type("LINE 1");
        window.await("the count", () -> window.text("foundCount").equals("11 found"));
        window.press(KeyEvent.VK_ENTER);
        assertThat(window.text("foundCount")).isEqualTo("11 of 11");
        assertThat(selection()).isEqualTo("line 1");
        window.press(KeyEvent.VK_F3);
        assertThat(window.text("foundCount")).isEqualTo("10 of 11");
        window.press(KeyEvent.VK_ESCAPE);
        assertThat(window.text("findMessage")).isEmpty();
        assertThat(window.team.isLatched()).isFalse();
        window.type("bots");
        assertThat(window.text("commandLine")).isEqualTo("bots");
    }

    @Test
    void onlyTheMessagesOfOneRobotAreShownAndTheOthersReturn() {
        window.add("one");
        window.add("two");
        window.command("1 move 5");
        window.command("2 move 5");
        window.awaitMessage("1 move 5: done");
        window.awaitMessage("2 move 5: done");
        window.click("messageRobots");
        window.press(KeyEvent.VK_DOWN);
        window.press(KeyEvent.VK_DOWN);
        window.press(KeyEvent.VK_ENTER);
        window.await("the filter", () -> window.text("messageRobots").startsWith("Only robot 1"));
        assertThat(window.text("messages")).contains("1 move 5: done").doesNotContain("2 move 5");
        window.click("messageRobots");
        window.press(KeyEvent.VK_DOWN);
        window.press(KeyEvent.VK_ENTER);
        window.awaitMessage("2 move 5: done");
    }

    @Test
    void theSizeOfTheTextIsChangedByKeyAndKept() {
        float usual = fontSize();
        window.focus("commandLine");
        window.pressWithCtrl(KeyEvent.VK_PLUS);
        window.pressWithCtrl(KeyEvent.VK_PLUS);
        assertThat(fontSize()).isEqualTo(usual + 2);
        window.await(
                "the setting",
                () -> window.settings.get("window.messages.larger").equals(Optional.of("2")));
        window.pressWithCtrl(KeyEvent.VK_0);
        assertThat(fontSize()).isEqualTo(usual);
    }

    private void add(MessageArea area, int from, int to) {
        IntStream.range(from, to).forEach(index -> area.line(new Line(Line.Kind.NOTICE, "line " + index)));
    }

    private JTextPane text() {
        return window.find("messages", JTextPane.class);
    }

    private float fontSize() {
        return text().getFont().getSize2D();
    }

    private String selection() {
        return text().getSelectedText();
    }

    private String firstInView() {
        String[] line = new String[1];
        window.run(() -> {
            JTextPane text = text();
            int top = text.viewToModel2D(new Point(10, text.getVisibleRect().y + 8));
            Element root = text.getDocument().getDefaultRootElement();
            Element found = root.getElement(root.getElementIndex(top));
            try {
                line[0] = text.getText(found.getStartOffset(), found.getEndOffset() - found.getStartOffset());
            } catch (BadLocationException e) {
                throw new AssertionError(e);
            }
        });
        return line[0];
    }

    /** Whether the message area needs more than a line of text for what it contains. */
    private boolean isBroken() {
        return bar().getMaximum() > 80;
    }

    private boolean isAtEnd() {
        JScrollBar bar = bar();
        return bar.getMaximum() > 400 && bar.getValue() + bar.getVisibleAmount() == bar.getMaximum();
    }

    private JScrollBar bar() {
        return window.find("messageArea", MessageArea.class).getVerticalScrollBar();
    }
}
