package majic.script.run;

import java.util.List;
import java.util.function.BiConsumer;
import majic.bot.BotException;
import majic.team.Member;
import org.jspecify.annotations.Nullable;

/** Passes what is to be plotted to the window, if there is one. Thread-safe. */
public final class Plotting {
    private volatile @Nullable BiConsumer<List<Integer>, List<String>> window;

    /**
     * Sets what shows plots.
     *
     * @param shows receives the numbers of the robots and the names of the parameters; must return at once
     */
    public void use(BiConsumer<List<Integer>, List<String>> shows) {
        window = shows;
    }

    /**
     * Shows readings as curves, in one window.
     *
     * @param robots in this order
     * @param parameters their names; those that a robot does not have are left out
     * @throws BotException if there is no window
     */
    public void show(List<Member> robots, List<String> parameters) {
        BiConsumer<List<Integer>, List<String>> present = window;
        if (present == null) {
            throw new BotException("a plot needs the window of MAJIC, which is not open");
        }
        present.accept(robots.stream().map(Member::number).toList(), parameters);
    }
}
