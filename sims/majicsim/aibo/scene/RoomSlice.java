package majicsim.aibo.scene;

import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import majicsim.world.Body;
import majicsim.world.Hit;
import majicsim.world.Point;
import majicsim.world.World;
import org.jspecify.annotations.Nullable;

/**
 * A vertical slice of the room in one direction from the camera: robots as blocks, a wall from floor to ceiling, floor
 * and ceiling. A map has no heights; all of its lines count as walls as high as the room.
 */
final class RoomSlice {
    static final double CEILING_MM = 2500;
    private static final double FAR_MM = 20_000;

    private final double eyeMm;
    private final Hit wall;
    private final List<Part> parts;

    /**
     * What the camera sees of a robot: an upright block of one colour.
     *
     * @param heightMm of its top above the floor
     * @param rgb its colour
     */
    private record Block(double heightMm, int rgb) {
        private static final Block UNKNOWN = new Block(300, 0xE0A030);
        private static final Map<String, Block> KNOWN = Map.of(
                "pioneer", new Block(240, 0xC02020),
                "hemisson", new Block(70, 0x30A040),
                "aibo", new Block(270, 0xE8E8F0));

        static Block of(Body body) {
            return KNOWN.getOrDefault(body.name(), UNKNOWN);
        }
    }

    /**
     * The part of the slice that a body occupies.
     *
     * @param entryMm where the slice enters it
     * @param exitMm where it leaves it
     * @param slant cosine of the angle of incidence, 1 perpendicular
     */
    private record Part(Block block, double entryMm, double exitMm, double slant) {

        /** The part of a body that lies in the direction (dx, dy) of length 1, or null if none does. */
        static @Nullable Part of(Body body, Vector eye, double dx, double dy) {
            List<Point> corners = body.outline();
            double entry = Double.POSITIVE_INFINITY;
            double exit = 0;
            double slant = 1;
            for (int i = 0; i < corners.size(); i++) {
                Point a = corners.get(i);
                Point b = corners.get((i + 1) % corners.size());
                double ex = b.xMm() - a.xMm();
                double ey = b.yMm() - a.yMm();
                double across = dx * ey - dy * ex;
                double toX = a.xMm() - eye.x();
                double toY = a.yMm() - eye.y();
                double along = (toX * ey - toY * ex) / across;
                double onEdge = (toX * dy - toY * dx) / across;
                if (!(along >= 0) || onEdge < 0 || onEdge > 1) {
                    continue;
                }
                exit = Math.max(exit, along);
                if (along < entry) {
                    entry = along;
                    slant = Math.abs(across) / Math.hypot(ex, ey);
                }
            }
            return entry <= exit ? new Part(Block.of(body), entry, exit, slant) : null;
        }
    }

    RoomSlice(World world, Body viewer, Vector eye, double azimuthDeg) {
        eyeMm = eye.z();
        wall = world.wallRay(new Point(eye.x(), eye.y()), azimuthDeg, FAR_MM);
        double dx = Math.cos(Math.toRadians(azimuthDeg));
        double dy = Math.sin(Math.toRadians(azimuthDeg));
        parts = world.bodies().stream()
                .filter(body -> body != viewer)
                .map(body -> Part.of(body, eye, dx, dy))
                .filter(Objects::nonNull)
                .filter(part -> part.entryMm() < wall.distanceMm())
                .sorted(Comparator.comparingDouble(Part::entryMm))
                .toList();
    }

    /** The surface at a slope: height over distance on the floor. */
    VisibleSurface look(double slope) {
        for (Part part : parts) {
            double frontMm = eyeMm + slope * part.entryMm();
            double backMm = eyeMm + slope * part.exitMm();
            double topMm = part.block().heightMm();
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

    private static VisibleSurface robot(Part part, double levelMm, double heightMm, double slant) {
        return new VisibleSurface(
                VisibleSurface.Kind.ROBOT,
                levelMm,
                heightMm,
                slant,
                1,
                part.block().rgb());
    }
}
