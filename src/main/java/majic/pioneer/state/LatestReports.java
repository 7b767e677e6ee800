package majic.pioneer.state;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import majic.pioneer.arcos.Encoders;
import majic.pioneer.arcos.Report;

/** The latest report of each kind that came beside the SIPs. Immutable. */
public final class LatestReports {
    static final LatestReports NONE = new LatestReports(List.of(), new EncoderTicks(0, 0));

    private final List<Report> latest;
    private final EncoderTicks ticks;

    private LatestReports(List<Report> latest, EncoderTicks ticks) {
        this.latest = latest;
        this.ticks = ticks;
    }

    /** These with a newer report in place of the last of its kind. */
    LatestReports with(Report report) {
        List<Report> now = new ArrayList<>(latest);
        now.removeIf(older -> older.getClass() == report.getClass());
        now.add(report);
        return new LatestReports(List.copyOf(now), report instanceof Encoders encoders ? counted(encoders) : ticks);
    }

    private EncoderTicks counted(Encoders now) {
        return latest(Encoders.class)
                .map(before -> ticks.plus(before, now))
                .orElse(new EncoderTicks(now.leftTicks(), now.rightTicks()));
    }

    /** The last one of a kind; empty before the first. */
    public <R extends Report> Optional<R> latest(Class<R> kind) {
        return latest.stream().filter(kind::isInstance).map(kind::cast).findFirst();
    }

    /** What the wheels' encoders have counted, without the roll-over. */
    Optional<EncoderTicks> ticks() {
        return latest(Encoders.class).map(last -> ticks);
    }
}
