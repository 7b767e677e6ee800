package majic.gui.kit;

import static org.assertj.core.api.Assertions.assertThat;

import com.formdev.flatlaf.FlatDarkLaf;
import com.formdev.flatlaf.FlatLightLaf;
import java.awt.Insets;
import javax.swing.LookAndFeel;
import javax.swing.UIManager;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

class ParagraphTest {
    private final LookAndFeel look = UIManager.getLookAndFeel();

    @AfterEach
    void restoreTheLook() throws Exception {
        UIManager.setLookAndFeel(look);
    }

    @Test
    void aLongTextNeedsNoMoreHeightThanARow() {
        Paragraph paragraph = new Paragraph("text", 2, 20);
        paragraph.show("words that need many lines in a narrow dialog ".repeat(10), false);

        assertThat(paragraph.getMinimumSize().height)
                .isLessThan(2 * paragraph.getFont().getSize());
    }

    @Test
    void itsTextBeginsAtItsEdgeAfterAChangeOfTheLookToo() {
        FlatLightLaf.setup();
        Paragraph paragraph = new Paragraph("text", 2, 20);
        FlatDarkLaf.setup();
        paragraph.updateUI();

        assertThat(paragraph.getInsets()).isEqualTo(new Insets(0, 0, 0, 0));
    }
}
