package majic.pioneer.parameters;

import java.util.Arrays;
import majic.bot.Parameter;
import majic.bot.RangeScan;
import majic.bot.Unit;
import majic.bot.Value;
import majic.driver.ParameterTable;
import majic.driver.ParameterTheme;
import majic.pioneer.state.Equipment;
import majic.pioneer.state.LaserScans;

/** The ranges of the laser that a robot may have. */
final class LaserParameters implements ParameterTheme<Equipment> {
    private static final int SECTOR_DEG = 30;
    private static final int SECTORS = 2 * LaserScans.HALF_FIELD_DEG / SECTOR_DEG;

    private final PioneerAccess access;

    LaserParameters(PioneerAccess access) {
        this.access = access;
    }

    @Override
    public void describe(ParameterTable table, Equipment equipment) {
        if (access.hasLaser()) {
            table.add(
                    Parameter.list(
                            "laser",
                            Unit.MM,
                            "nearest range of the laser in six sectors of 30 degrees, from the right to the left;"
                                    + " requested when read"),
                    access.laser(LaserParameters::sectors));
        }
    }

    private static Value sectors(RangeScan scan) {
        float[] nearest = new float[SECTORS];
        Arrays.fill(nearest, Float.NaN);
        for (int beam = 0; beam < scan.size(); beam++) {
            double fromRightDeg = LaserScans.HALF_FIELD_DEG
                    + scan.sensor().beams().get(beam).mount().headingDeg();
            float range = scan.rangeMm(beam);
            if (fromRightDeg >= 0 && fromRightDeg <= SECTORS * SECTOR_DEG && !Float.isNaN(range)) {
                int sector = (int) Math.min(SECTORS - 1, fromRightDeg / SECTOR_DEG);
                nearest[sector] = Float.isNaN(nearest[sector]) ? range : Math.min(nearest[sector], range);
            }
        }
        Value[] values = new Value[SECTORS];
        Arrays.setAll(values, sector -> mm(nearest[sector]));
        return Value.many(Arrays.asList(values));
    }

    private static Value mm(float range) {
        if (Float.isNaN(range)) {
            return Value.unknown("no beam of the laser measures there");
        }
        return Float.isInfinite(range) ? Value.CLEAR : Value.of(Math.round(range), Unit.MM);
    }
}
