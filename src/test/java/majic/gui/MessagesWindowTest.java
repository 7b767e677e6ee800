package majic.gui;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.stream.IntStream;
import javax.swing.JScrollBar;
import majic.gui.command.MessageArea;
import majic.log.Line;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Tag("jdk")
@Timeout(60)
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
    void aLostConnectionAndAStopThatFailedAreAlarms() {
        window.add("one").loseLink();
        window.awaitMessage("\u203c 1: connection lost");
        window.command("1 stop");
        window.awaitMessage("\u203c 1 stop: failed");
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
