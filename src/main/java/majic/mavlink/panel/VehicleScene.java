package majic.mavlink.panel;

import java.util.List;
import java.util.Optional;

/**
 * A snapshot of what the panel of a vehicle shows beside its parameters. Immutable.
 *
 * @param attitude its newest attitude; empty before the first one
 * @param modes those that can be set, in the order of their names
 * @param echoes the newest distances; empty without a range finder, or if the last ones are too old
 * @param messages the texts of its autopilot, the newest first
 * @param failsafe whether a failsafe is in force; empty if that was not reported lately
 */
public record VehicleScene(
        Optional<Attitude> attitude,
        List<String> modes,
        Optional<Echoes> echoes,
        List<Message> messages,
        Optional<Boolean> failsafe) {
    /** Keeps copies of the lists. */
    public VehicleScene {
        modes = List.copyOf(modes);
        messages = List.copyOf(messages);
    }

    /**
     * The attitude.
     *
     * @param rollDeg right side down positive
     * @param pitchDeg front up positive
     * @param compassDeg clockwise from north
     * @param current whether it is not too old to be the present one
     */
    public record Attitude(double rollDeg, double pitchDeg, double compassDeg, boolean current) {}

    /**
     * What the range finders have met.
     *
     * @param points in the frame of the vehicle
     * @param atNanos when the newest of them arrived, on the clock of the driver
     */
    public record Echoes(List<Echo> points, long atNanos) {
        /** Keeps a copy of the list. */
        public Echoes {
            points = List.copyOf(points);
        }
    }

    /**
     * A point that a range finder has met.
     *
     * @param xMm ahead positive
     * @param yMm left positive
     */
    public record Echo(double xMm, double yMm) {}

    /**
     * A text of the autopilot.
     *
     * @param kind how severe it is
     * @param text in the words of the autopilot
     * @param ageS since it arrived, s; NaN if that is not known
     */
    public record Message(Severity kind, String text, double ageS) {}

    /** How severe a text is. */
    public enum Severity {
        /** Something does not work. */
        ERROR,
        /** Something may soon not work. */
        WARNING,
        /** Anything else. */
        INFO
    }

    /** Returns this scene as one that is not received any more. */
    VehicleScene before() {
        return new VehicleScene(attitude, modes, Optional.empty(), messages, Optional.empty());
    }
}
