package majicsim.pioneer.model;

/**
 * What a model carries beside motors, sonar and bumpers. The vendor's parameter files do not contain it; what stands in
 * the table is our choice, documented there. No model in it has a laser. Immutable.
 *
 * @param generation of its firmware
 * @param hasGripper paddles and lift in front
 * @param hasGyro a gyro that the controller can report
 * @param charger docking mechanism as CONFIG names it: 0 none, 1 Pioneer 3, 2 PowerBot
 * @param hasCompass a compass that the SIP shows
 * @param smartBatteries batteries that report themselves, 0 for lead-acid ones
 * @param hasLaser a laser scanner on the deck, which its client may request
 */
public record Equipment(
        Generation generation,
        boolean hasGripper,
        boolean hasGyro,
        int charger,
        boolean hasCompass,
        int smartBatteries,
        boolean hasLaser) {
    private static final int PIONEER_3_CHARGER = 1;

    public boolean hasCharger() {
        return charger != 0;
    }

    Equipment withGripper() {
        return new Equipment(generation, true, hasGyro, charger, hasCompass, smartBatteries, hasLaser);
    }

    Equipment withGyro() {
        return new Equipment(generation, hasGripper, true, charger, hasCompass, smartBatteries, hasLaser);
    }

    Equipment withCharger() {
        return hasCharger()
                ? this
                : new Equipment(
                        generation, hasGripper, hasGyro, PIONEER_3_CHARGER, hasCompass, smartBatteries, hasLaser);
    }

    Equipment withCompass() {
        return new Equipment(generation, hasGripper, hasGyro, charger, true, smartBatteries, hasLaser);
    }

    Equipment withLaser() {
        return new Equipment(generation, hasGripper, hasGyro, charger, hasCompass, smartBatteries, true);
    }
}
