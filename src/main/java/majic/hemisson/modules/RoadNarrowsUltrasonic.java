package majic.hemisson.modules;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.Function;
import majic.bot.Parameter;
import majic.bot.Unit;
import majic.bot.Value;
import majic.driver.ParameterTable;
import majic.hemisson.line.Question;
import majic.hemisson.readings.RobotReadings;
import majic.time.WaitPolicy;

/**
 * The ultrasonic module behind the RoadNarrows firmware, which answers when the echoes are in (Hemisson sheet 10). That
 * takes the line for 65 ms, so it is not done while the robot moves.
 */
final class RoadNarrowsUltrasonic implements ExtensionModule {
    private static final double MEASURING_MS = 70;
    private static final int ECHOES = 17;
    private static final int HEX = 16;
    private static final double MM_PER_CM = 10;

    private static final Question CENTIMETRES = Question.ask("A,U,U,C", "a,U,U(,.*)?", Question.msFor(8));
    private static final Question LIGHT = Question.ask("A,U,L", "a,U,L,[0-9A-Fa-f]{1,4}", Question.msFor(10));
    private static final Question MEASURE = Question.ask("A,U,M", "a,U,M(,.*)?", MEASURING_MS);
    private static final Question ALL =
            Question.ask("A,U,A", "a,U,A(,[0-9A-Fa-f]{4}){" + ECHOES + "}", Question.msFor(5 + 5 * ECHOES));

    private final UnreportedSetting range = new UnreportedSetting();

    @Override
    public void describe(ParameterTable table, RobotReadings access) {
        table.add(
                Parameter.number("ultrasonic", Unit.MM, "the nearest echo, 30 to 6000 mm ahead; not while it moves"),
                () -> measured(access, RoadNarrowsUltrasonic::nearest));
        table.add(
                Parameter.list("ultrasonicEchoes", Unit.MM, "all echoes, nearest first; not while it moves"),
                () -> measured(access, Value::many));
        table.add(
                Parameter.number("ultrasonicLight", Unit.NONE, "how bright its front is, 0 dark to 255"),
                access.polledWhileRead(
                        LIGHT,
                        reply -> RobotReadings.count(
                                Integer.parseInt(reply.rest().substring(4), HEX))));
        range.describe(table, access, Ultrasonic.range().inWholes(), wish -> {
            int mm = (int) wish.number();
            String hex = String.format(Locale.ROOT, "A,U,R,%04X", mm);
            return new UnreportedSetting.Order(
                    Question.ask(hex, "a,U,R(,.*)?", Question.msFor(10)), Value.of(mm, Unit.MM));
        });
    }

    /**
     * Blocks for the measurement; unknown on a thread that must not block, because the robot measures only on request.
     */
    private static Value measured(RobotReadings access, Function<List<Value>, Value> reading) {
        return WaitPolicy.isAllowed() ? reading.apply(echoes(access)) : Value.unknown("no echo yet");
    }

    private static List<Value> echoes(RobotReadings access) {
        access.send(CENTIMETRES);
        access.send(MEASURE);
        String[] words = access.ask(ALL).text().split(",");
        List<Value> echoes = new ArrayList<>();
        for (int index = words.length - ECHOES; index < words.length; index++) {
            int cm = Integer.parseInt(words[index], HEX);
            if (cm > 0) {
                echoes.add(Value.of(cm * MM_PER_CM, Unit.MM));
            }
        }
        return echoes;
    }

    private static Value nearest(List<Value> echoes) {
        return echoes.isEmpty() ? Value.CLEAR : echoes.get(0);
    }
}
