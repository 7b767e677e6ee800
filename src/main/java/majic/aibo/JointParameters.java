package majic.aibo;

import java.util.List;
import java.util.function.Supplier;
import majic.bot.Motion;
import majic.bot.Parameter;
import majic.bot.ParameterTable;
import majic.bot.Range;
import majic.bot.Unit;
import majic.bot.Value;

/** The joints of the head: read as measured, set with an optional time that the motion is to take. */
final class JointParameters {
    /** Without a time a joint goes this fast, deg/s: quick, but not the jerk of a bare assignment. */
    private static final double USUAL_DEG_PER_S = 120;

    private static final double LEAST_MS = 100;
    private static final double LONGEST_MS = 30_000;
    private static final double LATE_S = 2;

    /** The joint follows its order with a lag. */
    private static final double SETTLING_S = 0.6;

    private static final double ARRIVED_DEG = 1;

    private final Senses senses;
    private final Supplier<AiboSession> session;

    JointParameters(Senses senses, Supplier<AiboSession> session) {
        this.senses = senses;
        this.session = session;
    }

    void describe(ParameterTable table) {
        add(table, "headPan", Sensor.HEAD_PAN, new Range(-91, 91), "where the head looks, left positive");
        add(table, "headTilt", Sensor.HEAD_TILT, new Range(-16, 44), "how far the head is raised");
        add(table, "neck", Sensor.NECK, new Range(-79, 2), "how far the neck is bowed; 0 is upright");
    }

    private void add(ParameterTable table, String name, Sensor sensor, Range range, String help) {
        Parameter time = Parameter.number("time", Unit.MS, "how long it takes").within(0, LONGEST_MS);
        table.add(
                        Parameter.number(name, Unit.DEG, help)
                                .within(range.min(), range.max())
                                .with(time),
                        () -> senses.value(sensor, 1, Unit.DEG))
                .moves((values, motion) -> turn(name, sensor, values, motion));
    }

    private void turn(String name, Sensor sensor, List<Value> values, Motion motion) {
        double target = values.get(0).number();
        double ms = values.size() > 1 ? values.get(1).number() : usualMs(sensor, target);
        AiboSession open = session.get();
        open.feet().power(motion);
        if (sensor == Sensor.HEAD_PAN) {
            motion.send(() -> open.sweep().home(target));
        }
        String command = name + ".val = " + Dialect.number(target) + " time:" + Dialect.number(Math.rint(ms));
        open.feet().perform(motion, open.runner().command(open.links().sensors(), command), ms / 1000 + LATE_S);
        motion.await(() -> Math.abs(senses.number(sensor).orElse(target) - target) < ARRIVED_DEG, SETTLING_S);
    }

    private double usualMs(Sensor sensor, double target) {
        double way = Math.abs(target - senses.number(sensor).orElse(0.0));
        return Math.max(LEAST_MS, way / USUAL_DEG_PER_S * 1000);
    }
}
