import java.util.List;
import majic.act.Argument;
import majic.act.MajicAct;
import majic.act.Role;
import majic.bot.Unit;

/** A robot drives ahead until something is near, then turns to the side with more room. */
public final class PioneerWander extends MajicAct {
    private static final long serialVersionUID = 1;
    private static final double STEP_S = 0.1;
    private static final double STATIONARY_MM_PER_SEC = 5;

    @Argument(value = "how fast it drives; 0 for the robot's cruise", unit = Unit.MM_PER_S, from = 0, to = 1000)
    private double speed = 0;

    @Argument(value = "the distance at which it turns; 0 for the robot's near", unit = Unit.MM, from = 0, to = 5000)
    private double near = 0;

    @Argument(value = "how far it turns", unit = Unit.DEG, from = 10, to = 180)
    private double turn = 100;

    @Override
    public List<Role> roles() {
        return List.of(Role.any(Role.ME).with("distanceFront", "distanceLeft", "distanceRight", "near", "cruise"));
    }

    @Override
    protected void behave() {
        while (true) {
            driveUntilNear();
            bot.turn(number("distanceLeft") > number("distanceRight") ? turn : -turn);
        }
    }

    private void driveUntilNear() {
        for (; !isSomethingNear(); pause(STEP_S)) {
            bot.drive(speed > 0 ? speed : number("cruise"), 0);
        }
        for (bot.drive(0, 0); Math.abs(number("speed")) > STATIONARY_MM_PER_SEC; pause(STEP_S)) {
            bot.drive(0, 0);
        }
    }

    private boolean isSomethingNear() {
        return number("distanceFront") < (near > 0 ? near : number("near"));
    }

    private double number(String parameter) {
        return bot.get(parameter).number();
    }
}
