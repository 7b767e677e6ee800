package majicsim.aibo.scene;

import java.util.Comparator;
import java.util.List;
import java.util.Objects;
import majicsim.world.Body;
import majicsim.world.Hit;
import majicsim.world.Point;
import majicsim.world.World;

/**
 * A vertical slice of the room in one direction from the camera: robots as blocks, a wall from floor to ceiling, floor
 * and ceiling. A map has no heights; all of its lines count as walls as high as the room.
 */
final class RoomSlice {
    static final double CEILING_MM = 2500;
    private static final double FAR_MM = 20_000;

    private final double eyeMm;
    private final Hit wall;
    private final List<BodyInSlice> parts;

    RoomSlice(World world, Body viewer, Vector eye, double azimuthDeg) {
        eyeMm = eye.z();
        wall = world.wallRay(new Point(eye.x(), eye.y()), azimuthDeg, FAR_MM);
        double dx = Math.cos(Math.toRadians(azimuthDeg));
        double dy = Math.sin(Math.toRadians(azimuthDeg));
        parts = world.bodies().stream()
                .filter(body -> body != viewer)
                .map(body -> BodyInSlice.of(body, eye, dx, dy))
                .filter(Objects::nonNull)
                .filter(part -> part.entryMm() < wall.distanceMm())
                .sorted(Comparator.comparingDouble(BodyInSlice::entryMm))
                .toList();
    }

    /** The surface at a slope: height over distance on the floor. */
    VisibleSurface look(double slope) {
        for (BodyInSlice part : parts) {
            double frontMm = eyeMm + slope * part.entryMm();
            double backMm = eyeMm + slope * part.exitMm();
            double topMm = part.look().heightMm();
            if (frontMm >= 0 && frontMm <= topMm) {
                return robot(part, part.entryMm(), frontMm, part.slant());
            }
            if (frontMm > topMm && backMm <= topMm) {
                return robot(part, (topMm - eyeMm) / slope, topMm, 1);
            }
        }
        return behindRobots(slope);
    }

    private VisibleSurface behindRobots(double slope) {
        double heightMm = eyeMm + slope * wall.distanceMm();
        if (heightMm < 0) {
            return VisibleSurface.of(VisibleSurface.Kind.FLOOR, -eyeMm / slope, 0);
        }
        if (heightMm > CEILING_MM) {
            return VisibleSurface.of(VisibleSurface.Kind.CEILING, (CEILING_MM - eyeMm) / slope, CEILING_MM);
        }
        if (!wall.found()) {
            return VisibleSurface.of(VisibleSurface.Kind.HAZE, FAR_MM, heightMm);
        }
        return new VisibleSurface(
                VisibleSurface.Kind.WALL, wall.distanceMm(), heightMm, wall.squareness(), wall.reflectivity(), 0);
    }

    private static VisibleSurface robot(BodyInSlice part, double levelMm, double heightMm, double slant) {
        return new VisibleSurface(
                VisibleSurface.Kind.ROBOT,
                levelMm,
                heightMm,
                slant,
                1,
                part.look().rgb());
    }
}
