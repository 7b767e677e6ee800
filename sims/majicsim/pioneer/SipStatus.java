package majicsim.pioneer;

/**
 * The part of a SIP that says how the robot is (ARCOS sheet 8).
 *
 * @param batteryTenthVolts in 0.1 V
 * @param left bit 0 left motor stalled, bits 1 to 7 rear bumpers
 * @param right bit 0 right motor stalled, bits 1 to 7 front bumpers
 * @param flags as sheet 8.1
 * @param analogPort the port chosen with ADSEL
 * @param digitalOut the digital outputs
 */
record SipStatus(int batteryTenthVolts, int left, int right, int flags, int analogPort, int digitalOut) {}
