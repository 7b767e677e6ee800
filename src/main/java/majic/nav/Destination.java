package majic.nav;

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

    /** Returns the place as the command {@code goto} takes it, in whole mm and degrees. */
    @Override
    public String toString() {
        String place = Math.round(pose.xMm()) + " " + Math.round(pose.yMm());
        return withHeading ? place + " " + Math.round(pose.headingDeg()) : place;
    }
}
