import majic.act.Argument;
import majic.act.MajicAct;
import majic.bot.Unit;

/** A robot goes to a place of the map by its name, or to coordinates. */
public final class GoTo extends MajicAct {
    private static final long serialVersionUID = 1;

    @Argument("the place of the map; without it x and y count")
    private String place = "";

    @Argument(value = "where it goes, in the frame of its poses", unit = Unit.MM)
    private double x = 0;

    @Argument(value = "where it goes, in the frame of its poses", unit = Unit.MM)
    private double y = 0;

    @Override
    protected void behave() {
        if (place.isBlank()) {
            goTo(x, y);
        } else {
            goTo(place);
        }
    }
}
