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

/** Motors, sonars, contacts and link, each shown as a word and a shape. For the event thread. */
final class PioneerLights {
    private static final String LONGEST = "right wheel ok";
    private static final double SILENT_MS = 500;

    /** More damaged packets than one in so many are shown as a warning. */
    private static final long DAMAGED_ONE_IN = 200;

    private final StatusLight motors = new StatusLight("motors", "Motor power; the first motion switches it on");
    private final StatusLight sonars = new StatusLight("sonars", "Sonars; without them there are no distances");
    private final StatusLight stallLeft = new StatusLight("stallLeft", "Stall of the left wheel's motor");
    private final StatusLight stallRight = new StatusLight("stallRight", "Stall of the right wheel's motor");
    private final StatusLight bumpers =
            new StatusLight("bumpers", "Touched bumper segments, counted clockwise: F front, R rear");
    private final StatusLight button = new StatusLight("stopButton", "The STOP button on the robot itself");
    private final StatusLight link = new StatusLight(
            "link", "Packets per second from the robot and damaged packets, or the time since the last packet");

    private final StatusLightsPanel panel =
            new StatusLightsPanel(LONGEST, List.of(motors, sonars, stallLeft, stallRight, bumpers, button, link));

    /** The panel with all lights. */
    StatusLightsPanel panel() {
        return panel;
    }

    /** Shows a robot without a report yet. */
    void show(MajicBot.Connection connection) {
        switch (connection) {
            case NEW, CONNECTING -> link.show(Kind.QUIET, "connecting");
            case CONNECTED -> link.show(Kind.WARNING, "no report yet");
            case LOST, CLOSED -> link.show(Kind.ALARM, "link lost");
        }
    }

    void show(PioneerScene scene) {
        PioneerState state = scene.state();
        panel.setCurrent(scene.isConnected());
        link.setEnabled(true);
        motors.show(state.motorsOn() ? Kind.GOOD : Kind.QUIET, state.motorsOn() ? "motors on" : "motors off");
        sonars.show(state.sonarOn() ? Kind.GOOD : Kind.WARNING, state.sonarOn() ? "sonars on" : "sonars off");
        showAlarm(stallLeft, state.stallLeft(), "left stuck", "left wheel ok");
        showAlarm(stallRight, state.stallRight(), "right stuck", "right wheel ok");
        showAlarm(button, state.stopButton(), "STOP pressed", "STOP ready");
        showBumpers(scene.bumpers(), state);
        showLink(scene);
    }

    private static void showAlarm(StatusLight light, boolean alarm, String so, String otherwise) {
        light.show(alarm ? Kind.ALARM : Kind.QUIET, alarm ? so : otherwise);
    }

    private void showBumpers(Bumpers fitted, PioneerState state) {
        int front = fitted.front(state);
        int rear = fitted.rear(state);
        int count = Integer.bitCount(front) + Integer.bitCount(rear);
        String touched = count > 1 ? count + " bumpers" : "bumper " + (front != 0 ? "F" : "R") + first(front | rear);
        boolean none = fitted.frontSegments() + fitted.rearSegments() == 0;
        showAlarm(bumpers, count > 0, touched, none ? "no bumpers" : "no contact");
    }

    /** Counted from 1. */
    private static int first(int segments) {
        return Integer.numberOfTrailingZeros(segments) + 1;
    }

    private void showLink(PioneerScene scene) {
        if (!scene.isConnected()) {
            show(scene.connection());
        } else if (scene.silenceMs() > SILENT_MS) {
            link.show(Kind.WARNING, String.format(Locale.ROOT, "silent %.1f s", scene.silenceMs() / 1000));
        } else {
            showRate(scene.state().sipsPerSec(), scene.packets());
        }
    }

    private void showRate(double perSecond, PacketCounts packets) {
        long damaged = packets.damagedPackets();
        String rate = String.format(Locale.ROOT, "link %.0f/s", perSecond);
        boolean bad = damaged * DAMAGED_ONE_IN > packets.packets();
        link.show(bad ? Kind.WARNING : Kind.GOOD, damaged == 0 ? rate : rate + ", " + damaged + " bad");
    }
}
