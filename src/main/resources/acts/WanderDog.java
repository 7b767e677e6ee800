import java.util.List;
import majic.act.MajicAct;
import majic.act.Role;
import majic.bot.Value;

/** An Aibo walks until an obstacle is near, measures to both sides, and turns to the side with more room. */
public final class WanderDog extends MajicAct {
    private static final long serialVersionUID = 1;
    private static final double LOOK_DEG = 70;
    private static final double TURN_DEG = 100;

    @Override
    public List<Role> roles() {
        return List.of(Role.any(Role.ME).types("aibo"));
    }

    @Override
    protected void behave() {
        while (true) {
            bot.move(2000, this::isSomethingNear);
            double left = roomAt(LOOK_DEG);
            double right = roomAt(-LOOK_DEG);
            bot.set("headPan", 0);
            say(left > right ? "to the left" : "to the right");
            bot.turn(left > right ? TURN_DEG : -TURN_DEG);
        }
    }

    private boolean isSomethingNear() {
        return bot.get("distanceFront").number() < bot.get("near").number();
    }

    /** Returns the distance that the head's far sensor measures at an angle, mm; infinite if it detects nothing. */
    private double roomAt(double degrees) {
        bot.set("headPan", degrees);
        pause(0.3);
        return bot.get("distance") instanceof Value.Number room ? room.amount() : Double.POSITIVE_INFINITY;
    }
}
