package majic.nav.mapping;

import majic.bot.Pose;

/**
 * Where a scan fits a reference.
 *
 * @param pose the robot's centre, in the frame of the reference
 * @param response the share of its echoes that lie on surfaces of the reference, 0 to 1
 * @param covariance of the pose, in the frame of the reference
 */
record ScanMatch(Pose pose, double response, Information covariance) {}
