import majic.act.MajicAct;

/** A robot builds a map: it drives where nothing is known yet, until nothing is left that it can reach. */
public final class Explore extends MajicAct {
    private static final long serialVersionUID = 1;

    @Override
    protected void behave() {
        say("explored " + explore());
    }
}
