package majic.program;

import java.util.List;
import majic.bot.BotType;
import majic.gui.kit.RobotSharing;
import majic.shared.SharedType;
import majic.shared.message.Sender;
import majic.team.Team;

/** The sites of which a program uses robots of other desks: its team obeys the STOP of each of them. */
final class UsedSites {
    private UsedSites() {}

    /**
     * Joins a team to the STOP of each site as soon as a robot of the site is used.
     *
     * @param types the types of robots, among them perhaps that of shared robots
     * @param sharing has the names under which this program sends
     */
    static void join(Team team, List<BotType> types, ProgramSharing sharing) {
        for (BotType type : types) {
            if (type instanceof SharedType shared) {
                shared.sendAs(() -> sender(sharing));
                shared.observeSites((connection, address, by) -> new UsedSite(team, connection, address, by));
            }
        }
    }

    /** Leaves the sites, once the robots are closed. Takes at most 0.5 s for each broker. */
    static void leave(List<BotType> types) {
        for (BotType type : types) {
            if (type instanceof SharedType shared) {
                shared.leaveSites();
            }
        }
    }

    private static Sender sender(ProgramSharing sharing) {
        RobotSharing.Place place = sharing.now().orElseGet(sharing::suggested);
        return Sender.ofThisRun(place.desk(), place.person());
    }
}
