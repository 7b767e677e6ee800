package majic.nav.localisation;

import majic.bot.Pose;
import majic.bot.Uncertainty;

/**
 * Where a robot is on a map, and how certain that is. Immutable.
 *
 * @param pose the most likely pose
 * @param uncertainty of that pose
 * @param placed whether it may be relied on; false while a robot is looked for or has been lost
 */
public record PoseEstimate(Pose pose, Uncertainty uncertainty, boolean placed) {}
