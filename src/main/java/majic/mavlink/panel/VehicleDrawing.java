package majic.mavlink.panel;

import java.awt.Graphics2D;
import java.util.Optional;
import majic.bot.Pose;
import majic.panel.DrawingColors;
import majic.panel.map.EchoContent;
import majic.panel.map.RobotDisc;
import org.jspecify.annotations.Nullable;

/**
 * A vehicle on its floor, to scale: its start, its path, and what its range finders have met. {@link #record} is for
 * the driver's threads, everything else for the event dispatch thread.
 */
final class VehicleDrawing extends EchoContent<VehicleDrawing.PlacedVehicle> {
    private static final Reach REACH = new Reach(0.06, 2000, 8000, 1000);

    private final Object recording = new Object();
    private VehicleScene.@Nullable Echoes recorded;

    /**
     * A vehicle, and where it is.
     *
     * @param pose on the floor
     * @param radiusMm of its hull
     * @param connected whether the pose is kept up to date
     */
    record PlacedVehicle(Pose pose, double radiusMm, boolean connected) {}

    VehicleDrawing() {
        super(REACH);
    }

    /** Adds a pose to the path, and echoes that were not added yet. */
    void record(Pose now, Optional<VehicleScene.Echoes> echoes) {
        poseReported(now);
        synchronized (recording) {
            echoes.filter(newest -> recorded == null || newest.atNanos() != recorded.atNanos())
                    .ifPresent(newest -> {
                        recorded = newest;
                        newest.points().forEach(point -> addEcho(now, point.xMm(), point.yMm(), newest.atNanos()));
                    });
        }
    }

    void show(PlacedVehicle vehicle) {
        showScene(vehicle);
    }

    @Override
    protected Pose pose(PlacedVehicle vehicle) {
        return vehicle.pose();
    }

    @Override
    protected double radiusMm(PlacedVehicle vehicle) {
        return vehicle.radiusMm();
    }

    @Override
    protected boolean isConnected(PlacedVehicle vehicle) {
        return vehicle.connected();
    }

    /** The newest echoes are the present: without new ones, the age of the others stays as it was. */
    @Override
    protected long nowNanos(PlacedVehicle vehicle) {
        synchronized (recording) {
            return recorded == null ? 0 : recorded.atNanos();
        }
    }

    /** What is sensed is shown by the echoes alone: a range finder has met nothing between them. */
    @Override
    protected void paintSensing(Graphics2D pen, PlacedVehicle vehicle, DrawingColors colors, double pxPerMm) {}

    @Override
    protected void paintBody(Graphics2D pen, PlacedVehicle vehicle, DrawingColors colors, double pxPerMm) {
        new RobotDisc(vehicle.radiusMm(), false).paint(pen, colors, pxPerMm);
    }
}
