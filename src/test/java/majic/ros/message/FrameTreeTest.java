package majic.ros.message;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

class FrameTreeTest {
    private static final String HALF_TURN = "'x':0,'y':0,'z':1,'w':0";
    private static final String UPSIDE_DOWN = "'x':1,'y':0,'z':0,'w':0";
    private static final String NO_TURN = "'x':0,'y':0,'z':0,'w':1";

    @Test
    void aSensorOnTheRobotIsFoundOverSeveralFramesAndMessages() {
        FrameTree tree = FrameTree.EMPTY
                .with(Recorded.json("{'transforms':[%s]}".formatted(frame("base_link", "/plate", 0.1, 0, NO_TURN))))
                .with(Recorded.json("{'transforms':[%s,%s]}"
                        .formatted(
                                frame("base_footprint", "base_link", 0, 0, NO_TURN),
                                frame("plate", "laser", 0.05, 0.02, HALF_TURN))));

        assertPoint(tree.find("laser", "base_footprint").orElseThrow(), new Vector(1000, 100, 0), -850, -80);
        assertPoint(tree.find("laser", "base_link").orElseThrow(), new Vector(1000, 100, 0), -850, -80);
    }

    @Test
    void theRobotMayBeABranchBesideTheSensor() {
        FrameTree tree = FrameTree.EMPTY.with(Recorded.json("{'transforms':[%s,%s]}"
                .formatted(frame("body", "base_link", 0.1, 0, HALF_TURN), frame("body", "laser", 0.3, 0, NO_TURN))));

        assertPoint(tree.find("laser", "base_link").orElseThrow(), new Vector(1000, 0, 0), -1200, 0);
    }

    @Test
    void aScannerThatHangsUpsideDownHasLeftAndRightExchanged() {
        FrameTree tree = FrameTree.EMPTY.with(
                Recorded.json("{'transforms':[%s]}".formatted(frame("base_link", "laser", 0, 0, UPSIDE_DOWN))));

        assertPoint(tree.find("laser", "base_link").orElseThrow(), new Vector(1000, 500, 0), 1000, -500);
    }

    @Test
    void unconnectedFramesAreNotFoundAndACircleEnds() {
        FrameTree tree = FrameTree.EMPTY.with(Recorded.json(
                "{'transforms':[%s,%s]}".formatted(frame("a", "b", 0, 0, NO_TURN), frame("b", "a", 0, 0, NO_TURN))));

        assertThat(tree.find("a", "laser")).isEmpty();
        assertThat(tree.find("a", "b")).isPresent();
        assertThat(FrameTree.EMPTY.find("laser", "laser")).contains(FrameTransform.NONE);
    }

    @Test
    void aTransformWithoutNumbersIsRefused() {
        assertThatThrownBy(() -> FrameTree.EMPTY.with(Recorded.json("{'transforms':[{'child_frame_id':'a'}]}")))
                .isInstanceOf(UnusableMessage.class);
    }

    private static void assertPoint(FrameTransform sensor, Vector seen, double xMm, double yMm) {
        Vector point = sensor.apply(seen);
        assertThat(point.x()).isCloseTo(xMm, within(1e-6));
        assertThat(point.y()).isCloseTo(yMm, within(1e-6));
    }

    private static String frame(String parent, String child, double x, double y, String rotation) {
        return "{'header':{'frame_id':'%s'},'child_frame_id':'%s','transform':{'translation':{'x':%s,'y':%s,'z':0},'rotation':{%s}}}"
                .formatted(parent, child, x, y, rotation);
    }
}
