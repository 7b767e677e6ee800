package majic.shared.desk;

import java.util.HashMap;
import java.util.Map;
import majic.bot.MajicBot;
import majic.bot.RangeScan;
import majic.bot.ScanListener;
import majic.shared.broker.BrokerMessage;
import majic.shared.broker.Quality;
import majic.shared.message.ScanMessage;
import majic.shared.message.SiteTopics.Part;
import majic.team.Member;
import majic.time.TimeSource;

/**
 * Publishes what the range sensors of one robot measure while another desk asks for it, at most five times a second for
 * each. A desk repeats its request: one that is gone costs nothing any more after some seconds. Thread-safe.
 */
final class RobotScans implements ScanListener {
    /** How long a request holds, seconds. */
    private static final double ASKED_S = 4;

    /** The time between two scans of a sensor, seconds. */
    private static final double SHORTEST_S = 0.2;

    /** An older scan is not published, and a published one not delivered later, seconds. */
    private static final int MOST_AGE_S = 1;

    private final DeskContext desk;
    private final Member member;
    private final TimeSource time;
    private final Map<String, Long> publishedNanos = new HashMap<>();
    private boolean asked;
    private long askedNanos;

    RobotScans(DeskContext desk, Member member) {
        this.desk = desk;
        this.member = member;
        this.time = desk.connection().time();
    }

    /** Publishes scans for some seconds from now on. */
    synchronized void ask() {
        askedNanos = time.nanos();
        if (!asked) {
            asked = true;
            member.bot().addScanListener(this);
        }
    }

    /** Ends it if no desk asks any more. Called by the timer of the desk, and with each scan. */
    synchronized void tick() {
        if (asked && time.secondsSince(askedNanos) > ASKED_S) {
            end();
        }
    }

    /** Publishes no more scans until a desk asks. */
    synchronized void end() {
        asked = false;
        member.bot().removeScanListener(this);
    }

    @Override
    public void scanned(RangeScan scan) {
        tick();
        MajicBot bot = member.bot();
        double ageS = Math.max(0, bot.time().nanos() / 1e9 - scan.timeS());
        if (ageS <= MOST_AGE_S && isDue(scan.sensor().name())) {
            ScanMessage message = ScanMessage.of(desk.clock().ms(), Math.round(ageS * 1000), scan);
            String topic = desk.topics().robot(desk.self().desk(), member.number(), Part.SCANS);
            desk.publish(BrokerMessage.json(topic, message.toJson(), Quality.AT_MOST_ONCE)
                    .expiringAfter(MOST_AGE_S));
        }
    }

    private synchronized boolean isDue(String sensor) {
        Long before = publishedNanos.get(sensor);
        boolean due = asked && (before == null || time.secondsSince(before) >= SHORTEST_S);
        if (due) {
            publishedNanos.put(sensor, time.nanos());
        }
        return due;
    }
}
