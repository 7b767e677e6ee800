package majic.gui;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Component;
import majic.gui.kit.Icons;
import majic.gui.kit.Pictogram;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

class TextSizeWindowTest {
    @AfterEach
    void restore() {
        try (TestWindow window = TestWindow.open()) {
            window.run(() -> LookAndFeels.changeTextSize(100, window.settings));
        }
    }

    @Test
    void allTextsAndSymbolsGrowAndTheChoiceIsKept() {
        try (TestWindow window = TestWindow.open()) {
            Component line = window.find("commandLine", Component.class);
            float before = line.getFont().getSize2D();
            window.run(() -> LookAndFeels.changeTextSize(150, window.settings));
            window.await("the larger text", () -> line.getFont().getSize2D() > 1.3f * before);
            assertThat(Icons.of(Pictogram.ADD, 20).getIconHeight()).isGreaterThan(26);
            window.await("the choice", () -> LookAndFeels.textSize(window.settings) == 150);
        }
    }

    @Test
    void aSizeThatIsNotOfferedIsLeftOut() {
        try (TestWindow window = TestWindow.openWith("window.textSize", "900")) {
            assertThat(LookAndFeels.textSize(window.settings)).isEqualTo(100);
        }
    }
}
