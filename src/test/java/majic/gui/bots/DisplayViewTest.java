package majic.gui.bots;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Dimension;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

class DisplayViewTest {
    private final JPanel display = new JPanel();
    private final JScrollPane scroll = new JScrollPane(new DisplayView(display));

    @BeforeEach
    void aDisplayThatWouldLikeMuchRoom() {
        display.setMinimumSize(new Dimension(200, 150));
        display.setPreferredSize(new Dimension(900, 900));
    }

    @Test
    void aDisplayGetsTheRoomThereIsHoweverMuchItWouldLike() {
        layOut(450, 240);

        assertThat(display.getSize()).isEqualTo(scroll.getViewport().getSize());
        assertThat(scroll.getVerticalScrollBar().isVisible()).isFalse();
        assertThat(scroll.getHorizontalScrollBar().isVisible()).isFalse();
    }

    @Test
    void itScrollsUpAndDownBelowItsLeastHeight() {
        layOut(450, 100);

        assertThat(scroll.getVerticalScrollBar().isVisible()).isTrue();
        assertThat(scroll.getHorizontalScrollBar().isVisible()).isFalse();
    }

    private void layOut(int width, int height) {
        scroll.setSize(width, height);
        scroll.doLayout();
        scroll.getViewport().doLayout();
        scroll.getViewport().getView().doLayout();
    }
}
