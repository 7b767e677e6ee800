package majicsim.world;

import java.util.function.ToDoubleFunction;

/** The light of a room's lamps. Walls cast shadows, robots do not. */
final class Lighting {
    private static final double AT_LAMP_MM = 1;

    private final Room room;
    private final Rays rays;

    Lighting(Room room, Rays rays) {
        this.room = room;
        this.rays = rays;
    }

    double at(Point place) {
        return sum(place, lamp -> lamp.lightAt(place));
    }

    double on(Pose sensor) {
        return sum(new Point(sensor.xMm(), sensor.yMm()), lamp -> lamp.lightOn(sensor));
    }

    double scatteredAt(Point place) {
        return sum(place, lamp -> lamp.scatteredAt(place));
    }

    private double sum(Point place, ToDoubleFunction<Lamp> share) {
        double sum = 0;
        for (Lamp lamp : room.lamps()) {
            double light = share.applyAsDouble(lamp);
            sum += light > 0 && isSeen(lamp, place) ? light : 0;
        }
        return sum;
    }

    private boolean isSeen(Lamp lamp, Point from) {
        double mm = from.distanceTo(lamp.at());
        if (mm < AT_LAMP_MM) {
            return true;
        }
        double direction = Math.toDegrees(
                Math.atan2(lamp.at().yMm() - from.yMm(), lamp.at().xMm() - from.xMm()));
        return !rays.castAtWalls(new Pose(from.xMm(), from.yMm(), direction), mm)
                .found();
    }
}
