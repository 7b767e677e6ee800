package majic.ros.readings;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import majic.ros.message.ContactMessage;
import majic.ros.message.ContactMessage.Contact;
import majic.ros.message.Hazard;
import majic.ros.message.HazardsMessage;
import majic.ros.message.HazardsMessage.Detection;
import majic.time.TimeSource;
import org.jspecify.annotations.Nullable;

/**
 * What contacts, cliff sensors and the base itself report: events, which last until the opposite event, and lists of
 * all that is there. Thread-safe.
 */
public final class ActiveHazards {
    private final TimeSource time;
    private final Map<String, Contact> contacts = new LinkedHashMap<>();
    private List<Detection> listed = List.of();
    private @Nullable Report last;

    /** Nothing reported yet. */
    ActiveHazards(TimeSource time) {
        this.time = time;
    }

    /**
     * A hazard that was reported.
     *
     * @param hazard its kind
     * @param place where it is, as the robot names it; may be empty
     * @param atNanos when it was reported last, on the robot's clock in MAJIC
     */
    public record Report(Hazard hazard, String place, long atNanos) {
        /**
         * Returns the hazard for users.
         *
         * @return such as {@code bump left}
         */
        public String words() {
            String where = place.replace('_', ' ');
            return where.contains(hazard.words()) ? where : (hazard.words() + " " + where).strip();
        }
    }

    synchronized void arrived(HazardsMessage message) {
        listed = message.detections();
        listed.forEach(detection -> report(detection.hazard(), detection.place()));
    }

    synchronized void arrived(ContactMessage message) {
        for (Contact contact : message.contacts()) {
            contacts.put(key(contact.hazard(), contact.place()), contact);
            if (contact.active()) {
                report(contact.hazard(), contact.place());
            }
        }
    }

    /** What is only near neither stops nor endangers the robot. */
    private void report(Hazard hazard, String place) {
        if (hazard != Hazard.PROXIMITY) {
            last = new Report(hazard, place, time.nanos());
        }
    }

    /**
     * Returns all hazards that are there now.
     *
     * @return in the order in which the robot names them
     */
    public synchronized List<Report> now() {
        List<Report> all = new ArrayList<>();
        contacts.values().stream()
                .filter(Contact::active)
                .forEach(contact -> all.add(new Report(contact.hazard(), contact.place(), time.nanos())));
        listed.forEach(detection -> all.add(new Report(detection.hazard(), detection.place(), time.nanos())));
        return all;
    }

    /**
     * Returns the hazard that was reported last, even if it is over; what is only near does not count. A contact that
     * is reported only when it changes counts as reported now while it lasts.
     *
     * @return empty if there was none on this connection
     */
    public synchronized Optional<Report> last() {
        Report known = last;
        if (known == null) {
            return Optional.empty();
        }
        Contact contact = contacts.get(key(known.hazard(), known.place()));
        boolean lasts = contact != null && contact.active();
        return Optional.of(lasts ? new Report(known.hazard(), known.place(), time.nanos()) : known);
    }

    private static String key(Hazard hazard, String place) {
        return hazard + " " + place;
    }

    /**
     * Returns whether the robot touches something or is blocked by it.
     *
     * @return true while a bumper is pressed or the base reports a stall
     */
    public boolean isBumped() {
        return now().stream().anyMatch(report -> report.hazard() == Hazard.BUMP || report.hazard() == Hazard.STALL);
    }
}
