package majic.panel.map;

import majic.bot.Pose;

/** The content of a map with one robot that the map can follow. Called on the event dispatch thread. */
public interface RobotContent extends MapContent {
    /**
     * Returns the pose that the map keeps in its middle when it follows.
     *
     * @return on the floor
     */
    Pose pose();

    /**
     * Returns a scale at which the robot and its surroundings are readable.
     *
     * @param sidePx the shorter side of the map
     * @return pixels a mm
     */
    double nearPxPerMm(int sidePx);
}
