package majic.hemisson.modules;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import majic.bot.Parameter;
import majic.bot.Unit;
import majic.bot.Value;
import majic.driver.ParameterTable;
import majic.hemisson.line.Question;
import majic.hemisson.line.Reply;
import majic.hemisson.readings.PolledQuestion;
import majic.hemisson.readings.RobotReadings;
import majic.time.WaitPolicy;
import org.jspecify.annotations.Nullable;

/**
 * The ultrasonic module, an SRF08 (Hemisson sheet 9): a ping, and 65 ms later up to 17 echoes, 30 mm to 6 m. Two short
 * exchanges, so it is measured while the robot moves as well.
 */
final class Ultrasonic implements ExtensionModule {
    private static final int ADDRESS = 0xE0;
    private static final int LIGHT = 0x01;
    private static final int ECHOES = 0x02;
    private static final int MOST_ECHOES = 17;
    private static final double MM_PER_CM = 10;

    /** What the bus reads while the sensor listens for its echoes. */
    private static final int BUSY = 0xFFFF;

    private static final double LISTENING_S = 0.08;
    private static final long LISTENING_NANOS = 80_000_000;
    private static final long RECENT_NANOS = 1_000_000_000;

    /** The sensor's own unit of its range, and the least of it, mm. */
    private static final double RANGE_STEP_MM = 43;

    private static final Question PING = Bus.write(ADDRESS, 0, 0x51);
    private static final Question FIRST = Bus.read(ADDRESS, LIGHT, 3);
    private static final Question ALL = Bus.read(ADDRESS, ECHOES, 2 * MOST_ECHOES);

    private final PingAndListen pingAndListen = new PingAndListen();
    private final UnreportedSetting range = new UnreportedSetting();

    /** Pings and reads in turn. While the sensor listens, nothing may ping it again. */
    private static final class PingAndListen implements PolledQuestion {
        private long pingedNanos;
        private boolean listening;

        @Override
        public synchronized @Nullable Question next(long nowNanos) {
            if (!mayPing(nowNanos)) {
                return null;
            }
            if (listening) {
                listening = false;
                return FIRST;
            }
            begin(nowNanos);
            return PING;
        }

        /** Starts a ping out of turn; false if one is under way. */
        synchronized boolean begins(long nowNanos) {
            boolean mayPing = mayPing(nowNanos);
            if (mayPing) {
                begin(nowNanos);
            }
            return mayPing;
        }

        private boolean mayPing(long nowNanos) {
            return !listening || nowNanos - pingedNanos >= LISTENING_NANOS;
        }

        private void begin(long nowNanos) {
            listening = true;
            pingedNanos = nowNanos;
        }
    }

    @Override
    public void describe(ParameterTable table, RobotReadings access) {
        table.add(
                Parameter.number("ultrasonic", Unit.MM, "the nearest echo, 30 to 6000 mm ahead within 55 deg"),
                () -> measured(access, FIRST, reply -> echo(reply.numbers(), 1)));
        table.add(
                Parameter.number("ultrasonicLight", Unit.NONE, "how bright its front is, 0 dark to 255"),
                () -> measured(
                        access,
                        FIRST,
                        reply -> RobotReadings.count(reply.numbers().get(0))));
        table.add(
                Parameter.list("ultrasonicEchoes", Unit.MM, "all echoes, nearest first; not while it moves"),
                () -> measured(access, ALL, Ultrasonic::echoes));
        range.describe(table, access, range(), wish -> {
            int steps = (int) Math.round(wish.number() / RANGE_STEP_MM) - 1;
            return new UnreportedSetting.Order(
                    Bus.write(ADDRESS, ECHOES, steps), Value.of((steps + 1) * RANGE_STEP_MM, Unit.MM));
        });
    }

    /** The parameter for the range of the sensor, which can only be set. */
    static Parameter range() {
        return Parameter.number("ultrasonicRange", Unit.MM, "how far it listens; the robot does not tell it")
                .within(RANGE_STEP_MM, RANGE_STEP_MM * 256);
    }

    /** Reads repeatedly requested values from the polled answers; pings only if there is none. */
    private Value measured(RobotReadings access, Question read, Function<Reply, Value> reading) {
        access.request(pingAndListen);
        Reply reply = read == FIRST ? access.last(FIRST, RECENT_NANOS) : null;
        if (reply == null && WaitPolicy.isAllowed()) {
            reply = ping(access, read);
        }
        return reply == null ? Value.unknown("no echo yet") : reading.apply(reply);
    }

    private Reply ping(RobotReadings access, Question read) {
        if (pingAndListen.begins(access.nanos())) {
            access.send(PING);
        }
        access.pause(LISTENING_S);
        return access.ask(read);
    }

    private static Value echo(List<Integer> bytes, int at) {
        int cm = 256 * bytes.get(at) + bytes.get(at + 1);
        if (cm == BUSY) {
            return Value.unknown("no echo yet");
        }
        return cm == 0 ? Value.CLEAR : Value.of(cm * MM_PER_CM, Unit.MM);
    }

    private static Value echoes(Reply reply) {
        List<Integer> bytes = reply.numbers();
        List<Value> echoes = new ArrayList<>();
        for (int at = 0; at + 1 < bytes.size() && bytes.get(at) + bytes.get(at + 1) > 0; at += 2) {
            echoes.add(echo(bytes, at));
        }
        return Value.many(echoes);
    }
}
