package majic.gui.map;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.stream.Collectors;
import majic.bot.Pose;
import majic.nav.Destination;
import majic.text.Texts;

/**
 * A place that robots are to go to.
 *
 * @param at where it is on the map
 * @param name of the place of the map; empty for any other point of the floor
 */
record Waypoint(Destination at, String name) {
    private static final Texts TEXTS = Texts.of(Waypoint.class);

    /**
     * Returns a script that sends robots from one waypoint to the next.
     *
     * @param robots at least one
     */
    static String script(List<Waypoint> waypoints, List<MapScene.Robot> robots) {
        return waypoints.stream()
                .map(waypoint -> waypoint.commands(robots) + "\n")
                .collect(Collectors.joining("", "# " + TEXTS.get("waypoints.script", waypoints.size()) + "\n", ""));
    }

    /**
     * Returns the commands that send robots there, one in each line: robots that were not placed have frames of their
     * own.
     */
    String commands(List<MapScene.Robot> robots) {
        return robots.stream()
                .collect(Collectors.groupingBy(
                        robot -> seenFrom(robot.origin()),
                        LinkedHashMap::new,
                        Collectors.mapping(robot -> "" + robot.number(), Collectors.joining(","))))
                .entrySet()
                .stream()
                .map(place -> place.getValue() + " goto " + place.getKey())
                .collect(Collectors.joining("\n"));
    }

    private String seenFrom(Pose origin) {
        return name.isEmpty() ? new Destination(at.pose().seenFrom(origin), at.withHeading()).toString() : name;
    }
}
