package majic.ros.panel;

import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import majic.bot.MajicBot;
import majic.panel.StatusLight;
import majic.panel.StatusLight.Kind;
import majic.panel.StatusLightsPanel;
import majic.ros.message.Hazard;
import majic.text.Texts;

/** Contacts, scanner and link, each shown as a word and a shape. For the event dispatch thread. */
final class RosLights {
    private static final Texts TEXTS = Texts.of(RosLights.class);
    private static final double SILENT_S = 0.7;

    private final StatusLight contacts = new StatusLight("contacts", TEXTS.get("contacts.tip"));
    private final StatusLight scanner = new StatusLight("scanner", TEXTS.get("scanner.tip"));
    private final StatusLight link = new StatusLight("link", TEXTS.get("link.tip"));

    private final StatusLightsPanel panel = new StatusLightsPanel(
            List.of(TEXTS.get("contacts.none"), TEXTS.get("scanner.old"), TEXTS.get("link.good", "888")),
            List.of(contacts, scanner, link));

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

    void show(RosScene scene) {
        panel.setCurrent(scene.isConnected());
        link.setEnabled(true);
        showContacts(scene);
        showScanner(scene);
        showLink(scene);
    }

    private void showContacts(RosScene scene) {
        if (scene.contacts().isEmpty()) {
            contacts.show(Kind.QUIET, TEXTS.get(scene.robot().hasContacts() ? "contacts.free" : "contacts.none"));
            return;
        }
        boolean onlyNear = scene.contacts().stream().allMatch(contact -> contact.hazard() == Hazard.PROXIMITY);
        contacts.show(
                onlyNear ? Kind.WARNING : Kind.ALARM,
                scene.contacts().stream().map(RosLights::words).distinct().collect(Collectors.joining(", ")));
    }

    /** The place is in the words of the robot. */
    private static String words(RosScene.Contact contact) {
        String hazard = TEXTS.get(key(contact.hazard()));
        return (hazard + " " + contact.place().replace('_', ' ')).strip();
    }

    private static String key(Hazard hazard) {
        return switch (hazard) {
            case BACKUP_LIMIT -> "hazard.backupLimit";
            case BUMP -> "hazard.bump";
            case CLIFF -> "hazard.cliff";
            case STALL -> "hazard.stall";
            case WHEEL_DROP -> "hazard.wheelDrop";
            case PROXIMITY -> "hazard.proximity";
            case OTHER -> "hazard.other";
        };
    }

    private void showScanner(RosScene scene) {
        if (!scene.robot().hasScanner()) {
            scanner.show(Kind.QUIET, TEXTS.get("scanner.none"));
        } else if (scene.scan().isPresent()) {
            scanner.show(Kind.GOOD, TEXTS.get("scanner.good"));
        } else {
            scanner.show(Kind.WARNING, TEXTS.get("scanner.old"));
        }
    }

    private void showLink(RosScene scene) {
        double silenceS = scene.link().silenceS();
        if (!scene.isConnected()) {
            show(scene.connection());
        } else if (silenceS > SILENT_S) {
            link.show(Kind.WARNING, TEXTS.get("link.silent", String.format(Locale.ROOT, "%.1f", silenceS)));
        } else {
            link.show(
                    Kind.GOOD,
                    TEXTS.get(
                            "link.good",
                            String.format(Locale.ROOT, "%.0f", scene.link().messagesPerSec())));
        }
    }
}
