package majic.gui;

import static org.assertj.core.api.Assertions.assertThat;

import com.formdev.flatlaf.FlatLightLaf;
import java.awt.Color;
import java.awt.image.BufferedImage;
import java.util.List;
import majic.bot.LabAccess.Furnishing;
import majic.bot.LabAccess.Lamp;
import majic.bot.LabAccess.Tape;
import majic.bot.LabAccess.Wall;
import majic.bot.Pose;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

class MapPaintTest {
    private static final int WIDTH = 600;
    private static final int HEIGHT = 400;

    private final TeamMap map = new TeamMap();

    @BeforeAll
    static void light() {
        FlatLightLaf.setup();
    }

    @Test
    void aRobotIsDrawnWhereItBelievesItIs() {
        BufferedImage empty = paint(scene());
        MapScene scene = scene(robot(new Pose(2000, 1500, 0), null));
        BufferedImage image = paint(scene);
        int x = (int) map.view().x(2100);
        int y = (int) map.view().y(1500);
        assertThat(new Color(image.getRGB(x, y))).isNotEqualTo(new Color(empty.getRGB(x, y)));
    }

    @Test
    void theTruthIsDrawnApartFromTheBelief() {
        MapScene believed = scene(robot(new Pose(1000, 1000, 0), null));
        MapScene both = scene(robot(new Pose(1000, 1000, 0), new Pose(3000, 2000, 90)));
        assertThat(differences(paint(believed), paint(both))).isBetween(20, 3000);
    }

    @Test
    void tapeAndLampsOfTheRoomAreDrawn() {
        Furnishing furnishing = new Furnishing(List.of(new Tape(500, 500, 2500, 500)), List.of(new Lamp(1500, 2500)));
        MapScene furnished = new MapScene(room(), furnishing, List.of(), List.of(), false);

        BufferedImage image = paint(furnished);

        assertThat(new Color(pixel(image, 1500, 2500))).isEqualTo(new Color(0xFFC107));
        assertThat(pixel(image, 1700, 500)).isNotEqualTo(pixel(paint(scene()), 1700, 500));
    }

    @Test
    void anEmptyMapHasAScale() {
        BufferedImage image = paint(MapScene.EMPTY);
        int ink = 0;
        for (int x = 0; x < 150; x++) {
            ink += image.getRGB(x, HEIGHT - 12) == image.getRGB(0, 0) ? 0 : 1;
        }
        assertThat(ink).isGreaterThan(40);
    }

    private int pixel(BufferedImage image, double xMm, double yMm) {
        return image.getRGB(
                (int) Math.floor(map.view().x(xMm)), (int) Math.floor(map.view().y(yMm)));
    }

    private static MapScene scene(MapScene.Robot... robots) {
        return new MapScene(room(), Furnishing.NONE, List.of(robots), List.of(), false);
    }

    private static List<Wall> room() {
        return List.of(new Wall(0, 0, 4000, 0), new Wall(4000, 0, 4000, 3000));
    }

    private static MapScene.Robot robot(Pose believed, @Nullable Pose truth) {
        return new MapScene.Robot(1, "Toy", 200, believed, truth, List.of(), true);
    }

    private BufferedImage paint(MapScene scene) {
        map.setSize(WIDTH, HEIGHT);
        map.show(scene);
        BufferedImage image = new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_INT_RGB);
        map.paint(image.getGraphics());
        return image;
    }

    private static int differences(BufferedImage one, BufferedImage other) {
        int count = 0;
        for (int pixel = 0; pixel < WIDTH * HEIGHT; pixel++) {
            count += one.getRGB(pixel % WIDTH, pixel / WIDTH) == other.getRGB(pixel % WIDTH, pixel / WIDTH) ? 0 : 1;
        }
        return count;
    }
}
