package majic.nav.grid;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import majic.bot.Pose;

/**
 * A map for robots: what is occupied, places with names, and lines that no robot crosses. Immutable. Its frame is that
 * of the file or of the robot that began it: mm, counterclockwise positive.
 *
 * @param grid what is free, occupied and unknown
 * @param places with names, in the order of the file
 * @param forbidden lines that no robot crosses; no sensor sees them, so they are not in the grid
 * @param home where robots start, if the map has such a place
 */
public record NavigationMap(
        OccupancyGrid grid, List<Place> places, List<ForbiddenLine> forbidden, Optional<Pose> home) {
    /**
     * A place with a name.
     *
     * @param name not empty
     * @param pose where it is; its heading counts only if {@code withHeading}
     * @param withHeading whether a robot has to turn to the heading there
     */
    public record Place(String name, Pose pose, boolean withHeading) {}

    /**
     * A line that no robot crosses, from one end to the other.
     *
     * @param fromXmm of one end
     * @param fromYmm of one end
     * @param toXmm of the other end
     * @param toYmm of the other end
     */
    public record ForbiddenLine(double fromXmm, double fromYmm, double toXmm, double toYmm) {}

    /** Copies the lists. */
    public NavigationMap {
        places = List.copyOf(places);
        forbidden = List.copyOf(forbidden);
    }

    /**
     * Returns this map with another grid.
     *
     * @param newGrid what is free, occupied and unknown
     * @return the same places, lines and home on it
     */
    public NavigationMap with(OccupancyGrid newGrid) {
        return new NavigationMap(newGrid, places, forbidden, home);
    }

    /**
     * Returns this map with a place, instead of one that had its name.
     *
     * @param place what is added, behind the others
     * @return the map
     */
    public NavigationMap with(Place place) {
        List<Place> all = new ArrayList<>(places);
        all.removeIf(other -> other.name().equalsIgnoreCase(place.name()));
        all.add(place);
        return new NavigationMap(grid, all, forbidden, home);
    }

    /**
     * Returns a place of this map.
     *
     * @param name whatever the case
     * @return empty if no place has that name
     */
    public Optional<Place> place(String name) {
        return places.stream()
                .filter(place -> place.name().equalsIgnoreCase(name))
                .findFirst();
    }

    /**
     * Returns this map without a place.
     *
     * @param name of the place, whatever the case
     * @return the other places on it
     */
    public NavigationMap without(String name) {
        List<Place> others = new ArrayList<>(places);
        others.removeIf(place -> place.name().equalsIgnoreCase(name));
        return new NavigationMap(grid, others, forbidden, home);
    }

    /**
     * Returns a map without places and lines.
     *
     * @param grid what is free, occupied and unknown
     * @return the map
     */
    public static NavigationMap of(OccupancyGrid grid) {
        return new NavigationMap(grid, List.of(), List.of(), Optional.empty());
    }
}
