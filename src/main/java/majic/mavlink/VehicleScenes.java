package majic.mavlink;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import majic.mavlink.message.AttitudeReport;
import majic.mavlink.message.ObstacleRing;
import majic.mavlink.message.RangeReading;
import majic.mavlink.message.StatusText;
import majic.mavlink.message.VehicleHeartbeat;
import majic.mavlink.panel.VehicleScene;
import majic.mavlink.panel.VehicleScene.Severity;
import majic.mavlink.parameters.VehicleParameters;
import majic.mavlink.session.Received;
import majic.mavlink.session.VehicleReports;
import majic.mavlink.session.VehicleSession;
import majic.time.TimeSource;

/** Makes the snapshots that the panel shows and recordings keep. Asks the vehicle for nothing. Thread-safe. */
final class VehicleScenes {
    /** An attitude comes ten times a second; an older one is shown as an old one, seconds. */
    private static final double OLD_ATTITUDE_S = 1;

    /** The vehicle has moved on since older echoes, seconds. */
    private static final double OLD_ECHO_S = 0.6;

    /** A heartbeat comes once a second; an older one says nothing about now, seconds. */
    private static final double OLD_HEARTBEAT_S = 3;

    private final TimeSource time;

    VehicleScenes(TimeSource time) {
        this.time = time;
    }

    VehicleScene scene(VehicleSession session) {
        return new VehicleScene(
                session.reports().newest(AttitudeReport.class).flatMap(this::attitude),
                VehicleParameters.settableModes(session),
                echoes(session.reports()),
                messages(session.texts().all()),
                failsafe(session));
    }

    /** By the newest heartbeat, or by a text that has come since and announces a failsafe. */
    private Optional<Boolean> failsafe(VehicleSession session) {
        return session.reports()
                .newest(VehicleHeartbeat.class)
                .filter(heartbeat -> time.secondsSince(heartbeat.atNanos()) <= OLD_HEARTBEAT_S)
                .map(heartbeat -> heartbeat.value().isFailsafe()
                        || session.texts().all().stream()
                                .anyMatch(text -> text.atNanos() - heartbeat.atNanos() > 0 && text.isFailsafe()));
    }

    private Optional<VehicleScene.Attitude> attitude(Received<AttitudeReport> received) {
        AttitudeReport report = received.value();
        return report.isUsable()
                ? Optional.of(new VehicleScene.Attitude(
                        report.rollDeg(),
                        report.pitchDeg(),
                        report.yawDeg(),
                        time.secondsSince(received.atNanos()) <= OLD_ATTITUDE_S))
                : Optional.empty();
    }

    private List<VehicleScene.Message> messages(List<StatusText> texts) {
        List<VehicleScene.Message> messages = new ArrayList<>();
        texts.forEach(text ->
                messages.add(new VehicleScene.Message(severity(text), text.text(), time.secondsSince(text.atNanos()))));
        Collections.reverse(messages);
        return messages;
    }

    private static Severity severity(StatusText text) {
        if (text.isError()) {
            return Severity.ERROR;
        }
        return text.isWarning() ? Severity.WARNING : Severity.INFO;
    }

    private Optional<VehicleScene.Echoes> echoes(VehicleReports reports) {
        List<VehicleScene.Echo> points = new ArrayList<>();
        long newestNanos = 0;
        for (Received<RangeReading> received : reports.ranges().values()) {
            RangeReading reading = received.value();
            if (isNew(received) && reading.isHorizontal() && reading.mm() < reading.mostMm()) {
                points.add(echo(reading.directionDeg(), reading.mm()));
                newestNanos = Math.max(newestNanos, received.atNanos());
            }
        }
        Received<ObstacleRing> ring = reports.newest(ObstacleRing.class)
                .filter(received -> isNew(received) && received.value().isUsable())
                .orElse(null);
        if (ring != null) {
            addEchoes(ring.value(), points);
            newestNanos = Math.max(newestNanos, ring.atNanos());
        }
        return points.isEmpty() ? Optional.empty() : Optional.of(new VehicleScene.Echoes(points, newestNanos));
    }

    private boolean isNew(Received<?> received) {
        return time.secondsSince(received.atNanos()) <= OLD_ECHO_S;
    }

    private static void addEchoes(ObstacleRing ring, List<VehicleScene.Echo> points) {
        for (int index = 0; index < ObstacleRing.COUNT; index++) {
            double mm = ring.mm(index);
            if (Double.isFinite(mm)) {
                points.add(echo(ring.firstDeg() + index * ring.stepDeg(), mm));
            }
        }
    }

    private static VehicleScene.Echo echo(double directionDeg, double mm) {
        double direction = Math.toRadians(directionDeg);
        return new VehicleScene.Echo(mm * Math.cos(direction), mm * Math.sin(direction));
    }
}
