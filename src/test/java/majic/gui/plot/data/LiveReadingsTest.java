package majic.gui.plot.data;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.OptionalInt;
import majic.bot.FakeBot;
import majic.bot.Pose;
import majic.bot.Unit;
import majic.drivertest.TestClock;
import majic.team.Team;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

class LiveReadingsTest {
    @AutoClose
    private final TestClock clock = new TestClock();

    @AutoClose
    private final Team team = new Team(clock.time());

    private final FakeBot bot = FakeBot.on(clock.time());

    @Test
    void aCurveHasAGapWhileTheConnectionIsLost() throws InterruptedException {
        bot.connect();
        team.add(bot, OptionalInt.empty());
        Samples samples = new Samples();
        PlotSource.Feed feed =
                new LiveSource(team, null).feed(new Quantity(1, "x", Quantity.WHOLE, Unit.MM, false), samples);
        bot.reportSpeed(0);
        clock.time().sleep(1);
        bot.cut();
        bot.place(new Pose(500, 0, 0));
        clock.time().sleep(1);
        feed.close();

        double[] values = samples.within(new Span(0, 10)).values();
        assertThat(values).contains(0.0).doesNotContain(500.0);
        assertThat(values[values.length - 1]).isNaN();
    }
}
