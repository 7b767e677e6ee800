import java.util.List;
import majic.act.Argument;
import majic.act.MajicAct;
import majic.act.Role;
import majic.bot.Unit;
import majic.bot.Value;

/**
 * A robot with a sensor in its head walks until an obstacle is near, measures to both sides, and turns to the side with
 * more room.
 */
public final class WanderDog extends MajicAct {
    private static final long serialVersionUID = 1;
    private static final double LOOK_DEG = 70;

    @Argument(value = "the distance at which it turns; 0 for the robot's own", unit = Unit.MM, from = 0, to = 5000)
    private double near = 0;

    @Argument(value = "how far it turns", unit = Unit.DEG, from = 10, to = 180)
    private double turn = 100;

    @Override
    public List<Role> roles() {
        return List.of(Role.any(Role.ME).with("distanceFront", "near", "headPan", "distance"));
    }

    @Override
    protected void behave() {
        while (true) {
            bot.move(2000, this::isSomethingNear);
            double left = roomAt(LOOK_DEG);
            double right = roomAt(-LOOK_DEG);
            bot.set("headPan", 0);
            say(left > right ? "to the left" : "to the right");
            bot.turn(left > right ? turn : -turn);
        }
    }

    private boolean isSomethingNear() {
        return bot.get("distanceFront").number()
                < (near > 0 ? near : bot.get("near").number());
    }

    /** Returns the distance that the head's far sensor measures at an angle, mm; infinite if it detects nothing. */
    private double roomAt(double degrees) {
        bot.set("headPan", degrees);
        pause(0.3);
        return bot.get("distance") instanceof Value.Number room ? room.amount() : Double.POSITIVE_INFINITY;
    }
}
