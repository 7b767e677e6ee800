package majicsim.aibo.body;

/**
 * The height and pitch of the front of the dog's body.
 *
 * @param shoulderMm height of the lower end of the neck above the floor
 * @param pitchDeg the slope of the back, positive if it rises to the front
 */
record ShoulderPose(double shoulderMm, double pitchDeg) {}
