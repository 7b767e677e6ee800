import java.util.List;
import majic.act.Argument;
import majic.act.MajicAct;
import majic.act.Role;
import majic.bot.Unit;
import majic.bot.Value;

/** A robot turns its head without moving, shows where the nearest obstacle is, and keeps its head turned to it. */
public final class HeadScan extends MajicAct {
    private static final long serialVersionUID = 1;
    private static final int STEP_DEG = 10;

    @Argument(value = "how far the head turns to each side", unit = Unit.DEG, from = 10, to = 90)
    private int widest = 90;

    @Override
    public List<Role> roles() {
        return List.of(Role.any(Role.ME).with("headPan", "distance"));
    }

    @Override
    protected void behave() {
        double nearest = Double.POSITIVE_INFINITY;
        int where = 0;
        for (int degrees = widest; degrees >= -widest; degrees -= STEP_DEG) {
            double distance = distanceAt(degrees);
            if (distance < nearest) {
                nearest = distance;
                where = degrees;
            }
        }
        bot.set("headPan", where);
        if (Double.isInfinite(nearest)) {
            say("nothing is in sight");
        } else {
            say("the nearest thing is " + Math.round(nearest / 10) + " cm away, at " + where + " degrees");
        }
    }

    private double distanceAt(int degrees) {
        bot.set("headPan", degrees);
        pause(0.3);
        return bot.get("distance") instanceof Value.Number seen ? seen.amount() : Double.POSITIVE_INFINITY;
    }
}
