package majic.script;

import java.util.List;
import java.util.stream.Collectors;
import majic.nav.Destination;

/** Writes places as a script, which can be saved, edited, and run as an act of any robot. */
public final class WaypointScript {
    private WaypointScript() {}

    /**
     * Returns the script of a way.
     *
     * @param places where the robot goes, in their order
     * @return a line for each; what {@link ScriptAct} takes
     */
    public static String of(List<Destination> places) {
        return places.stream()
                .map(place -> "me goto " + place + "\n")
                .collect(Collectors.joining("", "# Goes to " + places.size() + " places of the map.\n", ""));
    }
}
