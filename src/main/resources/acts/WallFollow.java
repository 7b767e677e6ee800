import java.util.List;
import majic.act.Argument;
import majic.act.MajicAct;
import majic.act.Role;
import majic.bot.Unit;

/**
 * A robot follows the wall on its right, into corners and around them, half a metre away unless another distance is
 * given.
 */
public final class WallFollow extends MajicAct {
    private static final long serialVersionUID = 1;
    private static final double STEP_S = 0.4;

    /** The distance ahead at which the robot is steered to reach the right distance from the wall. */
    private static final double AIM_MM = 800;

    private static final double SHARPEST_DEG_PER_SEC = 25;

    @Argument(value = "how far it stays away from the wall", unit = Unit.MM, from = 200, to = 1500)
    private double away = 500;

    @Override
    public List<Role> roles() {
        return List.of(Role.any(Role.ME).with("distanceFront", "distanceRight", "cruise"));
    }

    @Override
    protected void behave() {
        bot.move(5000, this::isBlocked);
        double before = toTheWall();
        while (true) {
            while (isBlocked()) {
                bot.turn(30);
                before = toTheWall();
            }
            double now = toTheWall();
            double speed = number("cruise") / 2;
            double drift = Math.atan2(now - before, speed * STEP_S);
            double aim = Math.atan2(away - now, AIM_MM);
            double bend = Math.toDegrees(aim - drift) / STEP_S / 2;
            bot.drive(speed, Math.max(-SHARPEST_DEG_PER_SEC, Math.min(bend, SHARPEST_DEG_PER_SEC)));
            before = now;
            pause(STEP_S);
        }
    }

    private boolean isBlocked() {
        return number("distanceFront") < away;
    }

    /** Returns a reading, limited to twice the intended distance; no reading counts as that limit. */
    private double toTheWall() {
        return Math.min(number("distanceRight"), 2 * away);
    }

    private double number(String parameter) {
        return bot.get(parameter).number();
    }
}
