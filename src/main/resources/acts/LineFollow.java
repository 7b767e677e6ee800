import java.util.List;
import majic.act.Argument;
import majic.act.MajicAct;
import majic.act.Role;
import majic.bot.Unit;

/** A robot finds a line of black tape ahead of it and follows it; it stops while an obstacle is in its way. */
public final class LineFollow extends MajicAct {
    private static final long serialVersionUID = 1;
    private static final double DARK = 90;
    private static final double SENSORS_AHEAD_MM = 57;
    private static final double BEND_DEG_PER_SEC = 35;
    private static final double STEP_S = 0.05;

    @Argument(value = "how fast it follows the line", unit = Unit.MM_PER_S, from = 10, to = 100)
    private double speed = 56;

    private transient boolean met;

    @Override
    public List<Role> roles() {
        return List.of(Role.any(Role.ME).with("groundLeft", "groundRight", "distanceFront", "near"));
    }

    @Override
    protected void behave() {
        for (; !met; pause(STEP_S)) {
            bot.move(2000, () -> meetsTape() || isSomethingNear());
        }
        bot.move(SENSORS_AHEAD_MM);
        bot.turn(180, this::isOnTape);
        say("on the tape");
        for (double bend = 0; true; pause(STEP_S)) {
            boolean left = isDark("groundLeft");
            boolean right = isDark("groundRight");
            if (left != right) {
                bend = left ? BEND_DEG_PER_SEC : -BEND_DEG_PER_SEC;
            }
            follow(left, right, bend);
        }
    }

    /** Drives along the tape; off the tape turns to the side where it was last detected. */
    private void follow(boolean left, boolean right, double bend) {
        if (isSomethingNear()) {
            bot.drive(0, 0);
        } else if (left || right) {
            bot.drive(speed, left && right ? 0 : bend);
        } else {
            bot.drive(0, bend);
        }
    }

    /** Returns whether the robot is on the tape, and stores it, since the robot rolls on a little. */
    private boolean meetsTape() {
        met = isOnTape();
        return met;
    }

    private boolean isOnTape() {
        return isDark("groundLeft") || isDark("groundRight");
    }

    private boolean isDark(String sensor) {
        return bot.get(sensor).number() < DARK;
    }

    private boolean isSomethingNear() {
        return bot.get("distanceFront").number() < bot.get("near").number();
    }
}
