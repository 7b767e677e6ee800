package majic.pioneer.state;

import java.util.Optional;
import majic.pioneer.arcos.Encoders;
import majic.pioneer.arcos.Report;

/** The latest report of each kind that came beside the SIPs. Immutable. */
public final class LatestReports {
    static final LatestReports NONE = new LatestReports(new Report[0], new EncoderTicks(0, 0));

    private final Report[] latest;
    private final EncoderTicks ticks;

    private LatestReports(Report[] latest, EncoderTicks ticks) {
        this.latest = latest;
        this.ticks = ticks;
    }

    /** These with a newer report in place of the last of its kind. */
    LatestReports with(Report report) {
        int place = place(report.getClass());
        Report[] now = new Report[Math.max(latest.length, place + 1)];
        System.arraycopy(latest, 0, now, 0, latest.length);
        now[place] = report;
        return new LatestReports(now, report instanceof Encoders encoders ? counted(encoders) : ticks);
    }

    private EncoderTicks counted(Encoders now) {
        return latest(Encoders.class)
                .map(before -> ticks.plus(before, now))
                .orElse(new EncoderTicks(now.leftTicks(), now.rightTicks()));
    }

    /** The last one of a kind; empty before the first. */
    public <R extends Report> Optional<R> latest(Class<R> kind) {
        int place = place(kind);
        return place < latest.length ? Optional.of(kind.cast(latest[place])) : Optional.empty();
    }

    /** Where the last report of a kind is; behind the others if there is none. */
    private int place(Class<? extends Report> kind) {
        int place = 0;
        while (place < latest.length && latest[place].getClass() != kind) {
            place++;
        }
        return place;
    }

    /** What the wheels' encoders have counted, without the roll-over. */
    Optional<EncoderTicks> ticks() {
        return latest(Encoders.class).map(last -> ticks);
    }
}
