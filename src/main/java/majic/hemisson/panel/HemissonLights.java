package majic.hemisson.panel;

import java.util.List;
import java.util.Locale;
import majic.hemisson.panel.HemissonScene.Line;
import majic.panel.StatusLight;
import majic.panel.StatusLight.Kind;
import majic.panel.StatusLightsPanel;

/** Motion, line and running mode, each by word and shape. For the event thread. */
final class HemissonLights {
    private static final String LONGEST = "answers missing";

    /** Longer than a robot that is polled ten times a second may be silent, seconds. */
    private static final double SILENT_S = 0.7;

    private final StatusLight motors =
            new StatusLight("motors", "The last motion command; the robot does not measure its wheels");
    private final StatusLight line = new StatusLight(
            "line", "The mean time from a question to its answer; or that answers are missing, or since when");
    private final StatusLight mode = new StatusLight(
            "mode",
            "The mode that the four switches selected when the robot was switched on; 1, 1, 1, 1 is remote control");
    private final StatusLightsPanel panel = new StatusLightsPanel(LONGEST, List.of(motors, line, mode));

    /** All of them. */
    StatusLightsPanel panel() {
        return panel;
    }

    void show(HemissonScene view) {
        mode.setEnabled(view.isConnected());
        showMotors(view);
        showLine(view.line());
        showMode(view);
    }

    private void showMotors(HemissonScene view) {
        if (view.line().outOfControl()) {
            motors.show(Kind.ALARM, "may be moving");
        } else if (!view.isConnected()) {
            motors.show(Kind.QUIET, "not driven");
        } else {
            showMotorsOfOneInReach(view);
        }
    }

    private void showMotorsOfOneInReach(HemissonScene view) {
        if (!view.state().moving()) {
            motors.show(Kind.QUIET, "stopped");
        } else if (view.isRemoteControlled()) {
            motors.show(Kind.GOOD, "moving");
        } else {
            motors.show(Kind.WARNING, "moves by itself");
        }
    }

    private void showLine(Line now) {
        switch (now.connection()) {
            case NEW, CONNECTING -> line.show(Kind.QUIET, "connecting");
            case LOST, CLOSED -> line.show(Kind.ALARM, "link lost");
            case CONNECTED -> showAnswers(now);
        }
    }

    private void showAnswers(Line now) {
        if (now.silentS() > SILENT_S) {
            line.show(Kind.WARNING, String.format(Locale.ROOT, "silent %.1f s", now.silentS()));
        } else if (now.missesAnswers()) {
            line.show(Kind.WARNING, "answers missing");
        } else {
            line.show(Kind.GOOD, HemissonReadings.milliseconds("link", now.quality()));
        }
    }

    private void showMode(HemissonScene view) {
        if (view.identity().switches().isEmpty()) {
            mode.show(Kind.QUIET, "mode not known");
        } else if (view.areSwitchesMoved()) {
            mode.show(Kind.WARNING, "switches moved since its start");
        } else {
            mode.show(view.isRemoteControlled() ? Kind.GOOD : Kind.WARNING, view.mode());
        }
    }
}
