package majic.pioneer.state;

import java.util.Arrays;
import java.util.Optional;
import majic.pioneer.arcos.Encoders;
import majic.pioneer.arcos.Report;
import majic.pioneer.arcos.ReportKind;
import org.jspecify.annotations.Nullable;

/** The latest report of each kind that came beside the SIPs. Immutable. */
public final class LatestReports {
    static final LatestReports NONE = new LatestReports(new Report[ReportKind.values().length], new EncoderTicks(0, 0));

    /** By the ordinal of their kind; null before the first. */
    private final @Nullable Report[] latest;

    private final EncoderTicks ticks;

    private LatestReports(@Nullable Report[] latest, EncoderTicks ticks) {
        this.latest = latest;
        this.ticks = ticks;
    }

    /** These with a newer report in place of the last of its kind. */
    LatestReports with(Report report) {
        @Nullable Report[] now = latest.clone();
        now[ReportKind.of(report).ordinal()] = report;
        return new LatestReports(now, report instanceof Encoders encoders ? counted(encoders) : ticks);
    }

    private EncoderTicks counted(Encoders now) {
        return latest(Encoders.class)
                .map(before -> ticks.plus(before, now))
                .orElse(new EncoderTicks(now.leftTicks(), now.rightTicks()));
    }

    /** The last one of a kind; empty before the first. */
    public <R extends Report> Optional<R> latest(Class<R> kind) {
        return Arrays.stream(latest).filter(kind::isInstance).map(kind::cast).findFirst();
    }

    /** What the wheels' encoders have counted, without the roll-over. */
    Optional<EncoderTicks> ticks() {
        return latest(Encoders.class).map(last -> ticks);
    }
}
