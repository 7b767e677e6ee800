package majic.gui;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Component;
import java.awt.Container;
import java.awt.Rectangle;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Tests the window with as many robots as a team can have. */
@Tag("jdk")
class FullTeamWindowTest {
    private static final int ROBOTS = 20;

    @AutoClose
    private final TestWindow window = TestWindow.open();

    @BeforeEach
    void addAll() {
        window.run(() -> window.frame.setSize(1280, 800));
        IntStream.rangeClosed(1, ROBOTS).forEach(number -> window.add("number " + number));
    }

    @Test
    void allCardsAreWholeWithTheirStopButtonsAlsoBelowAnAlarm() {
        assertCardsAreWhole();
        window.type.made.get(4).confirmStops(false);
        window.click("cardStop5");
        window.await("the alarm", () -> window.isShowing("stopAlarm"));
        window.run(window.frame::validate);
        assertCardsAreWhole();
    }

    /** So much of it shows "Hemisson" in full in the usual font. */
    @Test
    void theNameHasAlmostTwoThirdsOfANarrowCard() {
        Component line = window.find("cardLine3", Component.class);
        Component stop = window.find("cardStop3", Component.class);
        assertThat(stop.getX() - line.getX())
                .isGreaterThan((int) (0.65 * line.getParent().getWidth()));
    }

    private void assertCardsAreWhole() {
        Container strip = window.find("teamStrip", Container.class);
        List<Component> cards = Stream.of(strip.getComponents()).toList();
        assertThat(cards).hasSize(ROBOTS);
        Rectangle inside = new Rectangle(strip.getSize());
        for (Component card : cards) {
            Component stop = window.find("cardStop" + card.getName().substring("card".length()), Component.class);
            assertThat(inside.contains(card.getBounds())).as(card.getName()).isTrue();
            assertThat(new Rectangle(card.getSize()).contains(stop.getBounds()))
                    .as(stop.getName())
                    .isTrue();
            assertThat(stop.getHeight()).as(stop.getName()).isGreaterThanOrEqualTo(18);
            assertThat(cards.stream().filter(other -> other.getBounds().intersects(card.getBounds())))
                    .containsExactly(card);
        }
    }
}
