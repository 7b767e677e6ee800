import java.util.List;
import majic.act.MajicAct;
import majic.act.Role;

/** An Aibo walks a square with sides of half a metre and returns to its start. */
public final class AiboSquare extends MajicAct {
    private static final long serialVersionUID = 1;
    private static final int SIDES = 4;
    private static final double SIDE_MM = 500;

    @Override
    public List<Role> roles() {
        return List.of(Role.any(Role.ME).types("aibo"));
    }

    @Override
    protected void behave() {
        for (int side = 1; side <= SIDES; side++) {
            say("side " + side);
            bot.move(SIDE_MM);
            bot.turn(360.0 / SIDES);
        }
    }
}
