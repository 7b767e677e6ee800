package majic.pioneer.panel;

import java.util.List;
import java.util.Locale;
import majic.bot.MajicBot;
import majic.panel.StatusLight;
import majic.panel.StatusLight.Kind;
import majic.panel.StatusLightsPanel;
import majic.pioneer.arcos.PacketCounts;
import majic.pioneer.state.Bumpers;
import majic.pioneer.state.PioneerState;
import majic.text.Texts;

/** Motors, sonars, contacts and link, each shown as a word and a shape. For the event thread. */
final class PioneerLights {
    private static final Texts TEXTS = Texts.of(PioneerLights.class);
    private static final double SILENT_MS = 500;

    /** More damaged packets than one in so many are shown as a warning. */
    private static final long DAMAGED_ONE_IN = 200;

    private final StatusLight motors = new StatusLight("motors", TEXTS.get("motors.tip"));
    private final StatusLight sonars = new StatusLight("sonars", TEXTS.get("sonars.tip"));
    private final StatusLight stallLeft = new StatusLight("stallLeft", TEXTS.get("wheelLeft.tip"));
    private final StatusLight stallRight = new StatusLight("stallRight", TEXTS.get("wheelRight.tip"));
    private final StatusLight bumpers = new StatusLight("bumpers", TEXTS.get("bumpers.tip"));
    private final StatusLight button = new StatusLight("stopButton", TEXTS.get("stopButton.tip"));
    private final StatusLight link = new StatusLight("link", TEXTS.get("link.tip"));

    private final StatusLightsPanel panel = new StatusLightsPanel(
            List.of(
                    TEXTS.get("wheelRight.ok"),
                    TEXTS.get("wheelRight.stalled"),
                    TEXTS.get("stopButton.pressed"),
                    TEXTS.get("bumpers.none")),
            List.of(motors, sonars, stallLeft, stallRight, bumpers, button, link));

    /** The panel with all lights. */
    StatusLightsPanel panel() {
        return panel;
    }

    /** Shows a robot without a report yet. */
    void show(MajicBot.Connection connection) {
        switch (connection) {
            case NEW, CONNECTING -> link.show(Kind.QUIET, TEXTS.get("link.connecting"));
            case CONNECTED -> link.show(Kind.WARNING, TEXTS.get("link.noReport"));
            case LOST, CLOSED -> link.show(Kind.ALARM, TEXTS.get("link.lost"));
        }
    }

    void show(PioneerScene scene) {
        PioneerState state = scene.state();
        panel.setCurrent(scene.isConnected());
        link.setEnabled(true);
        motors.show(
                state.motorsOn() ? Kind.GOOD : Kind.QUIET, TEXTS.get(state.motorsOn() ? "motors.on" : "motors.off"));
        sonars.show(
                state.sonarOn() ? Kind.GOOD : Kind.WARNING, TEXTS.get(state.sonarOn() ? "sonars.on" : "sonars.off"));
        showAlarm(stallLeft, state.stallLeft(), "wheelLeft.stalled", "wheelLeft.ok");
        showAlarm(stallRight, state.stallRight(), "wheelRight.stalled", "wheelRight.ok");
        showAlarm(button, state.stopButton(), "stopButton.pressed", "stopButton.free");
        showBumpers(scene.bumpers(), state);
        showLink(scene);
    }

    private static void showAlarm(StatusLight light, boolean alarm, String alarmKey, String otherKey) {
        showAlarm(light, alarm, TEXTS.get(alarm ? alarmKey : otherKey));
    }

    private static void showAlarm(StatusLight light, boolean alarm, String words) {
        light.show(alarm ? Kind.ALARM : Kind.QUIET, words);
    }

    private void showBumpers(Bumpers fitted, PioneerState state) {
        int front = fitted.front(state);
        int rear = fitted.rear(state);
        int count = Integer.bitCount(front) + Integer.bitCount(rear);
        if (count > 1) {
            showAlarm(bumpers, true, TEXTS.get("bumpers.several", count));
        } else if (count == 1) {
            showAlarm(bumpers, true, TEXTS.get(front != 0 ? "bumpers.front" : "bumpers.rear", first(front | rear)));
        } else {
            boolean none = fitted.frontSegments() + fitted.rearSegments() == 0;
            showAlarm(bumpers, false, TEXTS.get(none ? "bumpers.none" : "bumpers.free"));
        }
    }

    /** Counted from 1. */
    private static int first(int segments) {
        return Integer.numberOfTrailingZeros(segments) + 1;
    }

    private void showLink(PioneerScene scene) {
        if (!scene.isConnected()) {
            show(scene.connection());
        } else if (scene.silenceMs() > SILENT_MS) {
            link.show(
                    Kind.WARNING,
                    TEXTS.get("link.silent", String.format(Locale.ROOT, "%.1f", scene.silenceMs() / 1000)));
        } else {
            showRate(scene.packetRate(), scene.packets());
        }
    }

    private void showRate(double perSecond, PacketCounts packets) {
        long damaged = packets.damagedPackets();
        String rate = String.format(Locale.ROOT, "%.0f", perSecond);
        boolean bad = damaged * DAMAGED_ONE_IN > packets.packets();
        link.show(
                bad ? Kind.WARNING : Kind.GOOD,
                damaged == 0 ? TEXTS.get("link.good", rate) : TEXTS.get("link.damaged", rate, damaged));
    }
}
