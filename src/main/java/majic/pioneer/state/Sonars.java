package majic.pioneer.state;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import majic.bot.Beam;
import majic.bot.Pose;
import majic.bot.RangeScan;
import majic.bot.RangeSensor;
import majic.pioneer.arcos.Sip;

/** The sonars of one model as a range sensor with a beam for each disc, and their readings as scans. Immutable. */
public final class Sonars {
    /** The full angle of a disc's cone, deg. */
    private static final double OPENING_DEG = 30;

    /** About 1 % of a distance; this is for one of 3 m. */
    private static final double NOISE_MM = 30;

    private final RangeSensor sensor;

    /** The beam of each disc by its number, -1 for a number without a disc. */
    private final int[] beams = new int[SonarScan.DISCS];

    private Sonars(List<SonarDisc> discs) {
        this.sensor = new RangeSensor("sonar", discs.stream().map(Sonars::beam).toList());
        Arrays.fill(beams, -1);
        IntStream.range(0, discs.size()).forEach(beam -> beams[discs.get(beam).number()] = beam);
    }

    /** The sonars of a model; empty if it has none, or their places are not known. */
    public static Optional<Sonars> of(Model model) {
        List<SonarDisc> discs = model.discs();
        return discs.isEmpty() ? Optional.empty() : Optional.of(new Sonars(discs));
    }

    private static Beam beam(SonarDisc disc) {
        Pose mount = new Pose(disc.xMm(), disc.yMm(), disc.axisDeg());
        return new Beam(mount, OPENING_DEG, 0, SonarScan.NOTHING_MM, NOISE_MM);
    }

    /** Returns their places and what they can measure, disc by disc in the order of the model. */
    public RangeSensor sensor() {
        return sensor;
    }

    /**
     * Returns the readings that are new in a SIP, with the odometry at that SIP and the time when it came.
     *
     * @return nothing measured for a disc without a new reading; empty if there is none at all
     */
    public Optional<RangeScan> scan(PioneerState state) {
        Sip sip = state.sip();
        float[] ranges = new float[sensor.beams().size()];
        Arrays.fill(ranges, Float.NaN);
        boolean measured = false;
        for (int index = 0; index < sip.readings(); index++) {
            int disc = sip.disc(index);
            if (disc < beams.length && beams[disc] >= 0) {
                ranges[beams[disc]] = state.sonar().rangeMm(disc);
                measured = true;
            }
        }
        return measured
                ? Optional.of(new RangeScan(sensor, state.atNanos() / 1e9, state.pose(), ranges))
                : Optional.empty();
    }
}
