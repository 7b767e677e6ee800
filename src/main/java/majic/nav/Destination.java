package majic.nav;

import java.util.Locale;
import majic.bot.Pose;
import majic.nav.grid.NavigationMap;

/**
 * Where a robot is to go.
 *
 * @param pose in the frame of the robots' poses; its heading counts only if {@code withHeading}
 * @param withHeading whether the robot turns to the heading there
 */
public record Destination(Pose pose, boolean withHeading) {
    /**
     * A place, whatever the heading.
     *
     * @param xMm in the frame of the robots' poses
     * @param yMm in the same frame
     */
    public Destination(double xMm, double yMm) {
        this(new Pose(xMm, yMm, 0), false);
    }

    /**
     * A place of a map.
     *
     * @param place one with a name
     */
    public Destination(NavigationMap.Place place) {
        this(place.pose(), place.withHeading());
    }

    @Override
    public String toString() {
        String place = String.format(Locale.ROOT, "%.0f %.0f", pose.xMm(), pose.yMm());
        return withHeading ? place + String.format(Locale.ROOT, " %.0f", pose.headingDeg()) : place;
    }
}
