import majic.act.Argument;
import majic.act.MajicAct;
import majic.bot.BotException;
import majic.bot.Unit;

/** A robot goes from place to place of the map, in the given order, and stays a while at each. */
public final class Patrol extends MajicAct {
    private static final long serialVersionUID = 1;

    @Argument("the places of the map, with blanks between them")
    private String places = "";

    @Argument(value = "how often it goes to all of them", from = 1, to = 1000)
    private int times = 1;

    @Argument(value = "how long it stays at each", unit = Unit.S, from = 0, to = 3600)
    private double pause = 5;

    @Override
    protected void behave() {
        if (places.isBlank()) {
            throw new BotException("which places? As in places=\"desk door\"");
        }
        for (int round = 1; round <= times; round++) {
            for (String place : places.strip().split("\\s+")) {
                say("round " + round + ", to " + place);
                goTo(place);
                pause(pause);
            }
        }
    }
}
