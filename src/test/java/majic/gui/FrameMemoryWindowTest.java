package majic.gui;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Rectangle;
import java.util.List;
import java.util.Optional;
import javax.swing.JFrame;
import javax.swing.SwingUtilities;
import majic.environment.Settings;
import majic.gui.bots.RobotTabs;
import org.junit.jupiter.api.Test;

class FrameMemoryWindowTest {
    private static final Rectangle NEW = new Rectangle(1, 2, 600, 400);

    @Test
    void theWindowOpensWhereItWas() throws Exception {
        assertThat(openedAt("40 60 900 640 normal 430 300")).isEqualTo(new Rectangle(40, 60, 900, 640));
    }

    @Test
    void aWindowWhoseScreenIsGoneOpensWhereANewOneDoes() throws Exception {
        assertThat(openedAt("90000 60 900 640 normal 430 300")).isEqualTo(NEW);
    }

    @Test
    void aWindowThatIsLargerThanTheScreenIsMadeToFit() throws Exception {
        assertThat(openedAt("40 60 90000 640 normal 430 300").width).isLessThan(20_000);
    }

    private static Rectangle openedAt(String place) throws Exception {
        Settings settings = Settings.inMemory();
        settings.put("window.place", place);
        Rectangle[] opened = new Rectangle[1];
        SwingUtilities.invokeAndWait(() -> {
            JFrame frame = new JFrame();
            frame.setBounds(NEW);
            new FrameMemory(frame, List.of(), new RobotTabs("tabs"), settings);
            opened[0] = frame.getBounds();
            frame.dispose();
        });
        return opened[0];
    }

    @Test
    void aNewPlaceIsKept() {
        try (TestWindow window = TestWindow.openWith("window.place", "40 60 900 640 normal 430 300")) {
            window.run(() -> window.frame.setSize(960, 700));
            window.await(
                    "the place",
                    () -> window.settings
                            .get("window.place")
                            .flatMap(WindowPlace::parse)
                            .map(place -> place.bounds().getSize())
                            .equals(Optional.of(window.frame.getSize())));
            assertThat(window.frame.getWidth()).isEqualTo(960);
        }
    }
}
