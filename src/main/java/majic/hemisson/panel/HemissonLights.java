package majic.hemisson.panel;

import java.util.List;
import java.util.Locale;
import majic.hemisson.panel.HemissonScene.Line;
import majic.panel.StatusLight;
import majic.panel.StatusLight.Kind;
import majic.panel.StatusLightsPanel;
import majic.text.Texts;

/** Motion, line and running mode, each by word and shape. For the event thread. */
final class HemissonLights {
    private static final Texts TEXTS = Texts.of(HemissonLights.class);

    /** Longer than a robot that is polled ten times a second may be silent, seconds. */
    private static final double SILENT_S = 0.7;

    private final StatusLight motors = new StatusLight("motors", TEXTS.get("motors.tip"));
    private final StatusLight line = new StatusLight("line", TEXTS.get("line.tip"));
    private final StatusLight mode = new StatusLight("mode", TEXTS.get("mode.tip"));
    private final StatusLightsPanel panel = new StatusLightsPanel(
            List.of(TEXTS.get("line.missing"), TEXTS.get("line.lost")), List.of(motors, line, mode));

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
            motors.show(Kind.ALARM, TEXTS.get("motors.alarm"));
        } else if (!view.isConnected()) {
            motors.show(Kind.QUIET, TEXTS.get("motors.notDriven"));
        } else {
            showMotorsOfOneInReach(view);
        }
    }

    private void showMotorsOfOneInReach(HemissonScene view) {
        if (!view.state().moving()) {
            motors.show(Kind.QUIET, TEXTS.get("motors.stopped"));
        } else if (view.isRemoteControlled()) {
            motors.show(Kind.GOOD, TEXTS.get("motors.moving"));
        } else {
            motors.show(Kind.WARNING, TEXTS.get("motors.byItself"));
        }
    }

    private void showLine(Line now) {
        switch (now.connection()) {
            case NEW, CONNECTING -> line.show(Kind.QUIET, TEXTS.get("line.connecting"));
            case LOST, CLOSED -> line.show(Kind.ALARM, TEXTS.get("line.lost"));
            case CONNECTED -> showAnswers(now);
        }
    }

    private void showAnswers(Line now) {
        if (now.silentS() > SILENT_S) {
            line.show(Kind.WARNING, TEXTS.get("line.silent", String.format(Locale.ROOT, "%.1f", now.silentS())));
        } else if (now.missesAnswers()) {
            line.show(Kind.WARNING, TEXTS.get("line.missing"));
        } else {
            line.show(Kind.GOOD, TEXTS.get("line.good", HemissonReadings.roundTrip(now.quality())));
        }
    }

    private void showMode(HemissonScene view) {
        if (view.identity().switches().isEmpty()) {
            mode.show(Kind.QUIET, TEXTS.get("mode.unknown"));
        } else if (view.areSwitchesMoved()) {
            mode.show(Kind.WARNING, TEXTS.get("mode.moved"));
        } else if (view.isRemoteControlled()) {
            mode.show(Kind.GOOD, TEXTS.get("mode.remoteControl"));
        } else {
            mode.show(Kind.WARNING, view.mode());
        }
    }
}
