package majicsim.pioneer.ranging;

import java.util.Arrays;
import majicsim.pioneer.model.SonarDisc;
import majicsim.world.Body;
import majicsim.world.Noise;
import majicsim.world.Point;
import majicsim.world.Pose;
import majicsim.world.World;
import org.jspecify.annotations.Nullable;

/**
 * What one sonar disc measures: the nearest echo in a cone of 30 degrees. A flat surface throws sound back only when it
 * is hit within about 30 degrees of perpendicular, beyond that the echo is lost; edges and corners scatter it and are
 * detected from near by in any direction.
 */
public final class SonarCone {
    /** No echo (ARCOS sheet 8.2). */
    static final double SILENCE_MM = 5000;

    private static final double NEAREST_MM = 100;
    private static final double LOST_BEYOND_DEG = 30;
    private static final double LOST_SIGMA_DEG = 2;
    private static final double RANGE_SIGMA = 0.01;

    private final World world;
    private final Body body;
    private final Noise noise;
    private final @Nullable ConeEchoes[] echoes = new ConeEchoes[SonarDisc.MOST];
    private long movements = -1;

    public SonarCone(World world, Body body, Noise noise) {
        this.world = world;
        this.body = body;
        this.noise = noise;
    }

    /** The range in mm from the disc, 100 to 5000; 5000 without an echo. */
    double rangeMm(SonarDisc disc) {
        double echoWithinDeg = LOST_BEYOND_DEG + noise.gaussian(LOST_SIGMA_DEG);
        double nearest = echoes(disc).nearestMm(echoWithinDeg);
        if (nearest >= SILENCE_MM) {
            return SILENCE_MM;
        }
        return Math.max(NEAREST_MM, Math.min(SILENCE_MM, nearest * noise.scale(RANGE_SIGMA)));
    }

    /** Computes the echoes only if something near has moved since the last time. */
    private ConeEchoes echoes(SonarDisc disc) {
        Pose pose = body.pose();
        long now = world.movementsNear(pose.xMm(), pose.yMm(), SILENCE_MM + body.reachMm());
        if (now != movements) {
            movements = now;
            Arrays.fill(echoes, null);
        }
        ConeEchoes known = echoes[disc.number()];
        if (known == null) {
            known = look(disc);
            echoes[disc.number()] = known;
        }
        return known;
    }

    private ConeEchoes look(SonarDisc disc) {
        Point at = body.pose().toWorld(disc.xMm(), disc.yMm());
        Pose view = new Pose(at.xMm(), at.yMm(), body.pose().toWorldDeg(disc.axisDeg()));
        return new ConeEchoes(world, body, view, SILENCE_MM);
    }
}
