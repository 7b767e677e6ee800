package majic.gui.start;

import java.util.function.BooleanSupplier;

/**
 * What the buttons of the start page do. All are called on the event dispatch thread and return at once.
 *
 * @param canStartLab whether a lab can be started
 * @param startLab starts the simulated lab and adds its robots
 * @param addBot opens the dialog that connects a robot
 * @param openLastTeam adds the robots of the team that was used last
 * @param openSession asks for a saved session or another script, and opens it
 * @param startTour begins the tour
 */
public record StartActions(
        BooleanSupplier canStartLab,
        Runnable startLab,
        Runnable addBot,
        Runnable openLastTeam,
        Runnable openSession,
        Runnable startTour) {}
