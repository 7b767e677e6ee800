package majic.program;

import majic.bot.BotControl;
import majic.bot.Guard;
import majic.bot.MajicBot;
import majic.bot.MotionReport;
import majic.nav.CurrentMap;
import majic.nav.Destination;
import majic.shared.desk.DeskMap;
import majic.shared.message.RequestedAction;

/**
 * The map of the team as other desks use it, for the robots that are shared.
 *
 * @param map with its navigator
 */
public record SharedMap(CurrentMap map) implements DeskMap {
    @Override
    public void localize(MajicBot robot) {
        map.localize(robot);
    }

    @Override
    public MotionReport goTo(MajicBot robot, BotControl control, RequestedAction.GoTo place, Guard guard) {
        return map.navigator().goTo(robot, control, new Destination(place.pose(), place.withHeading()), guard);
    }
}
