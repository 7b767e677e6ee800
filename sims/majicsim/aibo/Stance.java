package majicsim.aibo;

/**
 * How the front of the dog's body is held.
 *
 * @param shoulderMm height of the neck's foot above the floor
 * @param pitchDeg how far the back rises to the front
 */
record Stance(double shoulderMm, double pitchDeg) {}
