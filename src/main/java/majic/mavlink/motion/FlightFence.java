package majic.mavlink.motion;

import majic.bot.Unit;
import majic.bot.Value;
import org.jspecify.annotations.Nullable;

/**
 * The space in which MAJIC flies an aircraft: a cylinder about its home position, which the user sets. Immutable.
 *
 * @param radiusMm greatest distance from home over the ground, mm
 * @param lowestMm least height above home in the air, mm
 * @param highestMm greatest height above home, mm
 */
public record FlightFence(double radiusMm, double lowestMm, double highestMm) {
    /** The greatest number that a user may set, mm. */
    public static final double LARGEST_MM = 1_000_000;

    /**
     * A place.
     *
     * @param northMm to the north of home, mm
     * @param eastMm to the east of it, mm
     * @param heightMm above it, mm
     */
    record Place(double northMm, double eastMm, double heightMm) {
        Place plus(double north, double east, double up) {
            return new Place(northMm + north, eastMm + east, heightMm + up);
        }
    }

    /** Whether the numbers are a space at all. */
    public boolean isValid() {
        return radiusMm > 0 && lowestMm >= 0 && highestMm > lowestMm && highestMm <= LARGEST_MM;
    }

    /**
     * Tells how a place is outside.
     *
     * @param marginMm so far beyond a limit is not outside yet, mm
     * @return as a part of a sentence: {@code 12000 mm from home, and the fence is at 10000 mm}; null if it is inside
     */
    @Nullable
    String outside(Place place, double marginMm) {
        String beyond = above(place, marginMm);
        return beyond == null && place.heightMm() < lowestMm - marginMm
                ? mm(place.heightMm()) + " high, and the fence begins at " + mm(lowestMm)
                : beyond;
    }

    /** As {@link #outside}, for an aircraft that is taking off and may be too low. */
    @Nullable
    String above(Place place, double marginMm) {
        double distanceMm = Math.hypot(place.northMm(), place.eastMm());
        if (!(distanceMm <= radiusMm + marginMm)) {
            return mm(distanceMm) + " from home, and the fence is at " + mm(radiusMm);
        }
        return place.heightMm() <= highestMm + marginMm
                ? null
                : mm(place.heightMm()) + " high, and the fence ends at " + mm(highestMm);
    }

    private static Value mm(double mm) {
        return Value.of(Math.round(mm), Unit.MM);
    }
}
