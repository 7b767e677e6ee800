import java.util.List;
import majic.act.MajicAct;
import majic.act.Role;

/** An act of one's own: goes ahead as far as there is room, turns round, and does so again. */
public final class Pacer extends MajicAct {
    private static final long serialVersionUID = 1;
    private static final int LEGS = 4;
    private static final double LEG_MM = 600;

    /** Needs one robot, which detects what is ahead of it. */
    @Override
    public List<Role> roles() {
        return List.of(Role.any(Role.ME).with("distanceFront"));
    }

    @Override
    protected void behave() {
        for (int leg = 1; leg <= LEGS; leg++) {
            say("leg " + leg);
            bot.move(
                    LEG_MM,
                    () -> bot.get("distanceFront").number() < bot.get("near").number());
            bot.turn(180);
        }
    }
}
