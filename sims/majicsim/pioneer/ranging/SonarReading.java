package majicsim.pioneer.ranging;

/**
 * One new sonar range as a SIP carries it.
 *
 * @param disc 0 to 31
 * @param range raw, in the model's range units
 */
public record SonarReading(int disc, int range) {}
