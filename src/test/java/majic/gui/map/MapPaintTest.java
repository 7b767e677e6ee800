package majic.gui.map;

import static org.assertj.core.api.Assertions.assertThat;

import com.formdev.flatlaf.FlatDarkLaf;
import com.formdev.flatlaf.FlatLightLaf;
import java.awt.Color;
import java.awt.event.MouseEvent;
import java.awt.geom.Point2D;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import majic.bot.Pose;
import majic.bot.Uncertainty;
import majic.gui.kit.Palette;
import majic.gui.map.MapScene.PlannedWay;
import majic.lab.LabAccess.Furnishing;
import majic.lab.LabAccess.Lamp;
import majic.lab.LabAccess.Tape;
import majic.lab.LabAccess.Wall;
import majic.nav.grid.NavigationMap;
import majic.nav.grid.NavigationMap.ForbiddenLine;
import majic.nav.grid.NavigationMap.Place;
import majic.nav.grid.OccupancyGrid;
import majic.panel.DrawingColors;
import majic.panel.map.Trail;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

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
        assertThat(pixel(image, 2100, 1500)).isNotEqualTo(pixel(empty, 2100, 1500));
    }

    @Test
    void theTruthIsDrawnApartFromTheBelief() {
        MapScene believed = scene(robot(new Pose(1000, 1000, 0), null));
        MapScene both = scene(robot(new Pose(1000, 1000, 0), new Pose(3000, 2000, 90)));
        assertThat(differences(paint(believed), paint(both))).isBetween(20, 3000);
    }

    @Test
    void theUncertaintyOfAPlaceIsDrawnAsAnEllipseAroundTheRobot() {
        MapScene.Robot certain = robot(new Pose(2000, 1500, 0), null);
        BufferedImage small = paint(scene(with(certain, Uncertainty.of(300, 3))));
        BufferedImage large = paint(scene(with(certain, Uncertainty.of(600, 3))));

        assertThat(differences(paint(scene(certain)), small)).isGreaterThan(1000);
        assertThat(differences(paint(scene(certain)), large))
                .isGreaterThan(2 * differences(paint(scene(certain)), small));
    }

    private static MapScene.Robot with(MapScene.Robot robot, Uncertainty uncertainty) {
        return new MapScene.Robot(
                robot.number(),
                robot.label(),
                robot.bodyMm(),
                Pose.START,
                robot.reported(),
                uncertainty,
                null,
                new Trail(),
                true,
                false,
                PlannedWay.NONE);
    }

    @Test
    void aRobotThatHasNotConfirmedItsStopIsMarkedInTheAlarmColour() {
        MapScene.Robot quiet = robot(new Pose(2000, 1500, 0), null);
        MapScene.Robot unconfirmed = new MapScene.Robot(
                quiet.number(),
                quiet.label(),
                quiet.bodyMm(),
                Pose.START,
                quiet.reported(),
                Uncertainty.UNKNOWN,
                null,
                new Trail(),
                true,
                true,
                PlannedWay.NONE);

        assertThat(alarms(paint(scene(quiet)))).isZero();
        assertThat(alarms(paint(scene(unconfirmed)))).isGreaterThan(100);
    }

    @Test
    void theHeightOfARobotIsShownAbove200Mm() {
        MapScene.Robot standing = robot(new Pose(2000, 1500, 0), null);
        BufferedImage onTheFloor = paint(scene(standing));

        assertThat(differences(onTheFloor, paint(scene(standing.at(240))))).isZero();
        assertThat(differences(onTheFloor, paint(scene(standing.at(1234))))).isGreaterThan(30);
    }

    @Test
    void theHeightOfARobotIsInTheTipAndInTheDescriptionForScreenReaders() {
        MapScene.Robot standing = robot(new Pose(1000, 1000, 0), null);
        paint(scene(standing.at(180)));
        assertThat(map.getAccessibleContext().getAccessibleDescription()).isEqualTo("1 Toy");

        paint(scene(standing.at(1234)));
        assertThat(map.getAccessibleContext().getAccessibleDescription()).isEqualTo("1 Toy at a height of 1.2 m");
        assertThat(tip(1000, 1000)).endsWith("\nheight 1.2 m");
    }

    @Test
    void theWayOfARobotIsDrawnWithWhatItHasReservedAndWhyItWaits() {
        Pose here = new Pose(1000, 1500, 0);
        Pose place = new Pose(3500, 1500, 0);
        BufferedImage standing = paint(scene(robot(here, null)));
        BufferedImage driving = paint(scene(robot(here, null, new PlannedWay(List.of(place), List.of()))));
        List<Pose> reserved = List.of(here, new Pose(1500, 1500, 0));
        PlannedWay held = new PlannedWay(List.of(place), reserved, "Toy 2 stands in the way", OptionalInt.of(2));
        BufferedImage waiting = paint(scene(robot(here, null, held)));

        assertThat(pixel(driving, 2500, 1500)).isNotEqualTo(pixel(standing, 2500, 1500));
        assertThat(pixel(driving, 2500, 1600)).isEqualTo(pixel(standing, 2500, 1600));
        assertThat(pixel(driving, 1500, 1600)).isEqualTo(pixel(standing, 1500, 1600));
        assertThat(pixel(waiting, 1500, 1600)).isNotEqualTo(pixel(standing, 1500, 1600));
        assertThat(differences(driving, waiting)).isGreaterThan(1000);
    }

    @Test
    void theTipHasTheReasonWhyARobotWaits() {
        Pose here = new Pose(1000, 1500, 0);
        PlannedWay held =
                new PlannedWay(List.of(here), List.of(), "robot 2 (Toy) stands in the way", OptionalInt.of(2));
        paint(scene(robot(here, null, held)));

        assertThat(tip(here.xMm(), here.yMm())).endsWith("\nwaits: robot 2 (Toy) stands in the way");
    }

    @Test
    void anArrowShowsWhereRobotsAreToDriveTo() {
        BufferedImage before = paint(scene());
        map.previewTarget(new Pose(2000, 1500, 90));
        BufferedImage with = paint(scene());
        map.previewTarget(null);

        Point2D tail = map.view().pixel(2000, 1500);
        int x = (int) tail.getX();
        int y = (int) tail.getY();
        assertThat(with.getRGB(x, y - 20)).isNotEqualTo(before.getRGB(x, y - 20));
        assertThat(with.getRGB(x, y + 20)).isEqualTo(before.getRGB(x, y + 20));
        assertThat(differences(before, paint(scene()))).isZero();
    }

    private static int alarms(BufferedImage image) {
        int alarm = DrawingColors.current().alarm().getRGB();
        int count = 0;
        for (int x = 0; x < WIDTH; x++) {
            for (int y = 0; y < HEIGHT; y++) {
                count += image.getRGB(x, y) == alarm ? 1 : 0;
            }
        }
        return count;
    }

    @Test
    void tapeAndLampsOfTheRoomAreDrawn() {
        Furnishing furnishing = new Furnishing(List.of(new Tape(500, 500, 2500, 500)), List.of(new Lamp(1500, 2500)));
        MapScene furnished = new MapScene(room(), furnishing, List.of(), List.of(), null, false);

        BufferedImage image = paint(furnished);

        assertThat(new Color(pixel(image, 1500, 2500))).isEqualTo(new Color(0xFFC107));
        assertThat(pixel(image, 1700, 500)).isNotEqualTo(pixel(paint(scene()), 1700, 500));
    }

    @Test
    void theMapOfTheTeamIsDrawnWhereItIsKnown() {
        OccupancyGrid grid = OccupancyGrid.of(
                new Pose(1000, 500, 90), 1000, 2, 2, (column, row) -> column == 1 && row == 0 ? 1 : Double.NaN);
        NavigationMap mapped = NavigationMap.of(grid).with(new Place("desk", new Pose(3000, 2000, 0), false));
        MapScene scene = new MapScene(room(), Furnishing.NONE, List.of(), List.of(), new MapPicture(mapped), false);

        BufferedImage image = paint(scene);
        BufferedImage without = paint(scene());

        assertThat(pixel(image, 500, 2000)).isEqualTo(Palette.mixed(0.75).getRGB());
        assertThat(pixel(image, 500, 1000)).isEqualTo(pixel(without, 500, 1000));
        assertThat(differences(image, without)).isGreaterThan(1000);
    }

    @Test
    void forbiddenLinesAreDrawnInAColourOfTheirOwn() {
        OccupancyGrid grid = OccupancyGrid.of(Pose.START, 1000, 2, 1, (column, row) -> 0);
        NavigationMap mapped =
                new NavigationMap(grid, List.of(), List.of(new ForbiddenLine(500, 2000, 3500, 2000)), Optional.empty());

        BufferedImage image =
                paint(new MapScene(room(), Furnishing.NONE, List.of(), List.of(), new MapPicture(mapped), false));

        int violet = 0;
        for (int x = 0; x < WIDTH; x++) {
            for (int y = 0; y < HEIGHT; y++) {
                Color color = new Color(image.getRGB(x, y));
                violet += color.getRed() - color.getGreen() > 40 && color.getBlue() - color.getGreen() > 40 ? 1 : 0;
            }
        }
        assertThat(violet).isGreaterThan(100);
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void whatIsFreeOnTheMapDiffersFromWhatIsUnknownInBothLooks(boolean dark) {
        OccupancyGrid grid = OccupancyGrid.of(Pose.START, 1000, 2, 1, (column, row) -> column == 1 ? 0 : Double.NaN);
        MapPicture free = new MapPicture(NavigationMap.of(grid));
        try {
            if (dark) {
                FlatDarkLaf.setup();
            }
            BufferedImage image = paint(new MapScene(room(), Furnishing.NONE, List.of(), List.of(), free, false));

            Color known = new Color(pixel(image, 1370, 430));
            Color unknown = new Color(pixel(image, 370, 430));
            assertThat(Math.abs(known.getGreen() - unknown.getGreen())).isGreaterThan(12);
        } finally {
            light();
        }
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

    @Test
    void everythingOfTheRoomIsSeenAboveTheKey() {
        paint(scene(robot(new Pose(1000, 1000, 0), null)));

        Point2D corner = map.view().pixel(0, 0);
        assertThat(corner.getX()).isBetween(0.0, (double) WIDTH);
        assertThat(corner.getY()).isLessThan(HEIGHT - MapPainter.FOOT_PX);
    }

    @Test
    void aRobotBesideTheRoomHasSpaceForItsFrame() {
        paint(scene(robot(new Pose(4600, 1500, 0), null)));

        assertThat(map.view().pixel(4600 + 200 + 600, 1500).getX()).isLessThanOrEqualTo(WIDTH);
    }

    @Test
    void theTipNamesARobotAndElseThePosition() {
        paint(scene(robot(new Pose(1000, 1000, 0), null)));

        assertThat(tip(1000, 1000)).isEqualTo("1 Toy: x 1000 mm, y 1000 mm, heading 0° on the map");
        assertThat(tip(3000, 2000)).endsWith("double click shows everything");
    }

    private String tip(double xMm, double yMm) {
        Point2D at = map.view().pixel(xMm, yMm);
        return map.getToolTipText(new MouseEvent(
                map, MouseEvent.MOUSE_MOVED, 0, 0, (int) Math.round(at.getX()), (int) Math.round(at.getY()), 0, false));
    }

    private int pixel(BufferedImage image, double xMm, double yMm) {
        Point2D at = map.view().pixel(xMm, yMm);
        return image.getRGB((int) Math.floor(at.getX()), (int) Math.floor(at.getY()));
    }

    private static MapScene scene(MapScene.Robot... robots) {
        return new MapScene(room(), Furnishing.NONE, List.of(robots), List.of(), null, false);
    }

    private static List<Wall> room() {
        return List.of(new Wall(0, 0, 4000, 0), new Wall(4000, 0, 4000, 3000));
    }

    private static MapScene.Robot robot(Pose believed, @Nullable Pose truth) {
        return robot(believed, truth, PlannedWay.NONE);
    }

    private static MapScene.Robot robot(Pose believed, @Nullable Pose truth, PlannedWay way) {
        return new MapScene.Robot(
                1, "Toy", 200, Pose.START, believed, Uncertainty.UNKNOWN, truth, new Trail(), true, false, way);
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
