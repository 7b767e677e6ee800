package majicsim.aibo;

import java.util.Comparator;
import java.util.List;
import java.util.Objects;
import majicsim.world.Body;
import majicsim.world.Hit;
import majicsim.world.Point;
import majicsim.world.World;

/**
 * The room in one direction from an eye, cut upright: robots as blocks, a wall from floor to ceiling, and what lies below and above.
 * A map has no heights; all of its lines are taken for walls as high as the room.
 */
final class Slice {
    static final double CEILING_MM = 2500;
    private static final double FAR_MM = 20_000;

    private final double eyeMm;
    private final Hit wall;
    private final List<Slab> slabs;

    Slice(World world, Body viewer, Vector eye, double azimuthDeg) {
        eyeMm = eye.z();
        wall = world.wallRay(new Point(eye.x(), eye.y()), azimuthDeg, FAR_MM);
        double dx = Math.cos(Math.toRadians(azimuthDeg));
        double dy = Math.sin(Math.toRadians(azimuthDeg));
        slabs = world.bodies().stream()
                .filter(body -> body != viewer)
                .map(body -> Slab.of(body, eye, dx, dy))
                .filter(Objects::nonNull)
                .filter(slab -> slab.entryMm() < wall.distanceMm())
                .sorted(Comparator.comparingDouble(Slab::entryMm))
                .toList();
    }

    /** What is seen at a slope: rise over the way on the floor. */
    Sight look(double slope) {
        for (Slab slab : slabs) {
            double frontMm = eyeMm + slope * slab.entryMm();
            double backMm = eyeMm + slope * slab.exitMm();
            double topMm = slab.look().heightMm();
            if (frontMm >= 0 && frontMm <= topMm) {
                return robot(slab, slab.entryMm(), frontMm, slab.slant());
            }
            if (frontMm > topMm && backMm <= topMm) {
                return robot(slab, (topMm - eyeMm) / slope, topMm, 1);
            }
        }
        return behindRobots(slope);
    }

    private Sight behindRobots(double slope) {
        double heightMm = eyeMm + slope * wall.distanceMm();
        if (heightMm < 0) {
            return Sight.of(Sight.Kind.FLOOR, -eyeMm / slope, 0);
        }
        if (heightMm > CEILING_MM) {
            return Sight.of(Sight.Kind.CEILING, (CEILING_MM - eyeMm) / slope, CEILING_MM);
        }
        if (!wall.found()) {
            return Sight.of(Sight.Kind.HAZE, FAR_MM, heightMm);
        }
        double slant = Math.cos(Math.toRadians(wall.incidenceDeg()));
        return new Sight(Sight.Kind.WALL, wall.distanceMm(), heightMm, slant, wall.reflectivity(), 0);
    }

    private static Sight robot(Slab slab, double levelMm, double heightMm, double slant) {
        return new Sight(
                Sight.Kind.ROBOT, levelMm, heightMm, slant, 1, slab.look().rgb());
    }
}
