package majic.panel.map;

import majic.bot.Pose;

/** What lies on a floor with one robot that the map can follow. Asked on the event dispatch thread. */
public interface RobotContent extends MapContent {
    /**
     * What the map keeps in its middle when it follows.
     *
     * @return on the floor
     */
    Pose pose();

    /**
     * The scale at which the robot and what is around it are seen well.
     *
     * @param sidePx the shorter side of the map
     * @return pixels a mm
     */
    double nearPxPerMm(int sidePx);
}
