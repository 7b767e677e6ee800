package majic.panel.map;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.geom.Path2D;
import java.awt.geom.PathIterator;
import java.awt.geom.Rectangle2D;
import majic.bot.Pose;
import org.junit.jupiter.api.Test;

class TrailTest {
    private final Trail trail = new Trail();

    @Test
    void smallStepsAreLeftOut() {
        for (int mm = 0; mm <= 100; mm++) {
            trail.add(new Pose(mm, 0, 0));
        }
        assertThat(points()).isEqualTo(6);
    }

    @Test
    void aLongPathIsKeptInBoundedMemory() {
        for (int mm = 0; mm <= 1_000_000; mm += 10) {
            trail.add(new Pose(mm, 0, 0));
        }
        assertThat(points()).isLessThanOrEqualTo(2048);
        assertThat(extent().getMinX()).isZero();
        assertThat(extent().getMaxX()).isGreaterThan(995_000);
    }

    @Test
    void aPoseSetAnewDrawsNoLineAcrossTheFloor() {
        trail.add(new Pose(0, 0, 0));
        trail.add(new Pose(100, 0, 0));
        trail.add(new Pose(9000, 9000, 0));
        trail.add(new Pose(9100, 9000, 0));
        Path2D path = new Path2D.Double();

        trail.trace(path, 1);

        assertThat(path.intersects(new Rectangle2D.Double(4000, 4000, 1000, 1000)))
                .isFalse();
        assertThat(path.getBounds2D()).isEqualTo(new Rectangle2D.Double(0, 0, 9100, 9000));
    }

    @Test
    void aClearedPathIsEmpty() {
        trail.add(new Pose(500, 0, 0));
        trail.clear();
        assertThat(points()).isZero();
    }

    private int points() {
        Path2D path = new Path2D.Double();
        trail.trace(path, 0);
        int count = 0;
        for (PathIterator points = path.getPathIterator(null); !points.isDone(); points.next()) {
            count++;
        }
        return count;
    }

    private Rectangle2D extent() {
        Rectangle2D extent = new Rectangle2D.Double();
        trail.extend(extent);
        return extent;
    }
}
