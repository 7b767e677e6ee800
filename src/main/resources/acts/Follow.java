import majic.act.Argument;
import majic.act.MajicAct;
import majic.bot.MotionFailed;
import majic.bot.Pose;
import majic.bot.Unit;
import majic.nav.Destination;

/**
 * A robot goes after another one of the team, around what is in the way, and stops at a distance from it. It ends when
 * the other robot has not moved for half a minute. It goes by the places of both robots, not by its sensors.
 */
public final class Follow extends MajicAct {
    private static final long serialVersionUID = 1;
    private static final double MOVED_MM = 200;
    private static final double STEP_S = 0.5;
    private static final double LONGEST_S = 30;

    @Argument("the robot ahead: its number or its name")
    private String leader = "1";

    @Argument(value = "the distance between the middles of the robots", unit = Unit.MM, from = 300, to = 10000)
    private double distance = 1000;

    @Override
    protected void behave() {
        Pose followed = poseOf(leader);
        follow(followed);
        for (double waited = 0; waited < LONGEST_S; waited += STEP_S) {
            if (hasLeft(followed)) {
                followed = poseOf(leader);
                follow(followed);
                waited = 0;
            }
            pause(STEP_S);
        }
    }

    private boolean hasLeft(Pose place) {
        return poseOf(leader).distanceMm(place) > MOVED_MM;
    }

    private void follow(Pose there) {
        Pose here = pose();
        double share = distance / here.distanceMm(there);
        if (share < 1) {
            double x = there.xMm() + share * (here.xMm() - there.xMm());
            double y = there.yMm() + share * (here.yMm() - there.yMm());
            try {
                goTo(bot, new Destination(x, y), () -> hasLeft(there));
            } catch (MotionFailed e) {
                say(e.getMessage());
            }
        }
    }
}
