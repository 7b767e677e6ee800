import majic.act.Argument;
import majic.act.MajicAct;
import majic.bot.Unit;

/** A robot goes along a square, with sides of half a metre unless another length is given, and returns to its start. */
public final class AiboSquare extends MajicAct {
    private static final long serialVersionUID = 1;
    private static final int SIDES = 4;

    @Argument(value = "how long a side is", unit = Unit.MM, from = 50, to = 3000)
    private double side = 500;

    @Override
    protected void behave() {
        for (int number = 1; number <= SIDES; number++) {
            say("side " + number);
            bot.move(side);
            bot.turn(360.0 / SIDES);
        }
    }
}
