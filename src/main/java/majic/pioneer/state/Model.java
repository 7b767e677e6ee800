package majic.pioneer.state;

import java.util.List;
import majic.bot.BotProfile;
import majic.bot.Range;

/**
 * The properties of one model of robot. Immutable.
 *
 * @param subclass its name in the handshake
 * @param known whether its scaling is known, by the table, a parameter file or a library; if not, the values are
 *     careful ones
 * @param hull its outline
 * @param discs its sonars; none where they are not known
 * @param scaling of its SIPs
 * @param topSpeedMmPerSec by design
 * @param topTurnDegPerSec by design
 * @param frontBumpers segments it has from the factory
 * @param rearBumpers segments it has from the factory
 */
public record Model(
        String subclass,
        boolean known,
        Hull hull,
        List<SonarDisc> discs,
        Scaling scaling,
        double topSpeedMmPerSec,
        double topTurnDegPerSec,
        int frontBumpers,
        int rearBumpers) {
    private static final double CRUISE_MM_PER_SEC = 300;
    private static final double CRUISE_TURN_DEG_PER_SEC = 50;
    private static final double NEAR_MM = 500;

    /** Copies the list of sonars. */
    public Model {
        discs = List.copyOf(discs);
    }

    /** This model behind a library, which scales the reports itself. */
    public Model scaledByLibrary() {
        return known ? this : with(hull, discs, Scaling.CURRENT);
    }

    /** This model with a part of its sonars only. */
    Model with(List<SonarDisc> fitted) {
        return with(hull, fitted, scaling);
    }

    /** This model as one robot is built and counts; it is known if its scale is. */
    public Model with(Hull newHull, List<SonarDisc> newDiscs, Scaling newScaling) {
        return new Model(
                subclass,
                newScaling.isKnown(),
                newHull,
                newDiscs,
                newScaling,
                topSpeedMmPerSec,
                topTurnDegPerSec,
                frontBumpers,
                rearBumpers);
    }

    public BotProfile profile(Ramps ramps) {
        int speed = ramps.topSpeedMmPerSec();
        int turn = ramps.topTurnDegPerSec();
        return new BotProfile(
                hull.swingMm(),
                new Range(-speed, speed),
                new Range(-turn, turn),
                Math.min(CRUISE_MM_PER_SEC, speed),
                Math.min(CRUISE_TURN_DEG_PER_SEC, turn),
                NEAR_MM,
                false);
    }
}
