package majic.ros.panel;

import java.util.List;
import java.util.Optional;
import majic.bot.MajicBot.Connection;
import majic.bot.Range;
import org.jspecify.annotations.Nullable;

/** Scenes of a robot of 105 mm with all sensors. */
final class Scenes {
    static final RosScene.Robot ROBOT =
            new RosScene.Robot(105, new Range(-220, 220), new Range(-160, 160), true, true, false);

    private Scenes() {}

    static RosScene of(
            @Nullable ScanEchoes scan,
            List<RosScene.Contact> contacts,
            RosScene.Battery battery,
            List<RosScene.Topic> topics) {
        return new RosScene(
                ROBOT,
                Connection.CONNECTED,
                new RosScene.Link(0, 42),
                Optional.ofNullable(scan),
                contacts,
                battery,
                topics);
    }

    static RosScene of(ScanEchoes scan) {
        return of(scan, List.of(), RosScene.Battery.UNKNOWN, List.of());
    }

    /** A scan all round, with an echo in each direction at one distance. */
    static ScanEchoes circle(double mm, long atNanos) {
        double[] x = new double[360];
        double[] y = new double[360];
        for (int degree = 0; degree < 360; degree++) {
            x[degree] = mm * Math.cos(Math.toRadians(degree));
            y[degree] = mm * Math.sin(Math.toRadians(degree));
        }
        return ScanEchoes.of(x, y, atNanos);
    }
}
