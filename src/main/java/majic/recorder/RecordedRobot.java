package majic.recorder;

import majic.bot.Pose;

/**
 * A robot of a recording.
 *
 * @param number its number in the team
 * @param type the name of its type, as in addresses
 * @param label the short name of its type for users
 * @param make maker and model
 * @param bodyMm radius of a circle it fits in
 * @param estimates whether its pose is only dead reckoning
 * @param origin where its own frame lies on the map
 * @param inLab its name in the simulated lab; empty for a real robot, whose origin is a guess
 * @param addedS since when it is in the recording, seconds
 */
public record RecordedRobot(
        int number,
        String type,
        String label,
        String make,
        double bodyMm,
        boolean estimates,
        Pose origin,
        String inLab,
        double addedS) {}
