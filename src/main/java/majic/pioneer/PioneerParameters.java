package majic.pioneer;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import majic.bot.Parameter;
import majic.bot.ParameterTable;
import majic.bot.Unit;
import majic.bot.Value;
import majic.pioneer.arcos.Config;
import majic.pioneer.arcos.Identity;
import majic.pioneer.arcos.SipTail;
import org.jspecify.annotations.Nullable;

/** The parameters of a Pioneer besides those that every robot has. All are read from what the robot said last. */
final class PioneerParameters {
    private static final Value NOTHING_YET = Value.unknown("no reading yet");

    /** What robots send that cannot tell their charge. */
    private static final int CHARGE_UNKNOWN = 0;

    private final ParameterTable table;
    private final Supplier<@Nullable Session> session;

    PioneerParameters(ParameterTable table, Supplier<@Nullable Session> session) {
        this.table = table;
        this.session = session;
    }

    /** Those that every model has. */
    void describe(Switches switches) {
        table.add(Parameter.yesNo("motors", "whether the motors are on"), reading(s -> Value.yesNo(s.motorsOn())))
                .writes(values -> switches.motors(values.get(0).isYes()));
        table.add(Parameter.onOff("sonarPower", "whether the sonars fire"), reading(s -> Value.onOff(s.sonarOn())))
                .writes(values -> switches.sonar(values.get(0).isYes()));
        table.add(Parameter.onOff("beep", "tones, to find out which robot it is"), switches::beeping)
                .writes(values -> switches.beep(values.get(0).isYes()));
        describeHealth();
        describeContact();
        describeFirmware();
    }

    private void describeHealth() {
        add(
                Parameter.number("voltage", Unit.V, "of the battery; a 12 V robot wants charging below 11.5"),
                s -> Value.of(s.volts(), Unit.V));
        add(Parameter.number("battery", Unit.PERCENT, "charge, on robots that can tell"), PioneerParameters::charge);
        add(
                Parameter.number("packetRate", Unit.NONE, "packets from the robot a second; about 10"),
                s -> Value.of(s.sipsPerSec(), Unit.NONE));
    }

    private static Value charge(PioneerState state) {
        int percent = state.sip().tail().chargePercent();
        return percent == SipTail.ABSENT || percent <= CHARGE_UNKNOWN
                ? Value.unknown("this robot tells only its voltage")
                : Value.of(percent, Unit.PERCENT);
    }

    private void describeContact() {
        add(Parameter.yesNo("bumped", "whether a bumper is touched or a motor stalled"), this::bumped);
        add(Parameter.yesNo("stallLeft", "whether the left motor is stalled"), s -> Value.yesNo(s.stallLeft()));
        add(Parameter.yesNo("stallRight", "whether the right motor is stalled"), s -> Value.yesNo(s.stallRight()));
        add(
                Parameter.yesNo("stopButton", "whether the STOP button on the robot is pressed"),
                s -> Value.yesNo(s.stopButton()));
    }

    private Value bumped(PioneerState state) {
        Session open = session.get();
        boolean touched =
                open != null && Bumpers.of(open.model(), open.config()).touched(state);
        return Value.yesNo(touched || state.stalled());
    }

    private void describeFirmware() {
        table.add(Parameter.text("model", "how it calls its make"), known(s -> identity(s, Identity::subclass)));
        table.add(Parameter.text("robotName", "the name its owner gave it"), known(s -> identity(s, Identity::name)));
        table.add(Parameter.text("firmware", "version of the robot's own program"), known(PioneerParameters::version));
    }

    private static Value identity(Session open, Function<Identity, String> part) {
        Identity identity = open.identity();
        return identity == null ? Value.unknown("not connected") : Value.text(part.apply(identity));
    }

    private static Value version(Session open) {
        Config config = open.config();
        return config == null ? Value.unknown("the robot does not say") : Value.text(config.version());
    }

    /** Those that depend on where the sonars sit. */
    void describeSonars(Model model) {
        List<Integer> discs = model.known()
                ? model.discs().stream().map(SonarDisc::number).toList()
                : IntStream.range(0, SonarScan.DISCS).boxed().toList();
        add(Parameter.list("sonar", Unit.MM, "all sonar ranges in order, mm from each disc"), s -> all(discs, s));
        for (int disc : discs) {
            add(
                    Parameter.number("sonar" + disc, Unit.MM, "range from the surface of sonar disc " + disc),
                    s -> range(disc, s));
        }
        for (Side side : Side.values()) {
            if (model.discs().stream().anyMatch(side::isWatchedBy)) {
                add(Parameter.number(side.parameter(), Unit.MM, side.help()), s -> gap(side, s));
            }
        }
    }

    private static Value all(List<Integer> discs, PioneerState state) {
        List<Value> ranges = new ArrayList<>();
        discs.forEach(disc -> ranges.add(range(disc, state)));
        return Value.many(ranges);
    }

    private static Value range(int disc, PioneerState state) {
        if (!state.sonar().hasHeard(disc)) {
            return state.sonarOn() ? NOTHING_YET : Value.unknown("the sonars are off");
        }
        int range = state.sonar().rangeMm(disc);
        return range >= SonarScan.NOTHING_MM ? Value.CLEAR : Value.of(range, Unit.MM);
    }

    private static Value gap(Side side, PioneerState state) {
        Double gap = state.gaps().get(side);
        if (gap == null) {
            return Value.unknown(state.sonarOn() ? "no reading yet" : "the sonars are off");
        }
        return gap.isInfinite() ? Value.CLEAR : Value.of(Math.round(gap), Unit.MM);
    }

    private void add(Parameter parameter, Function<PioneerState, Value> reader) {
        table.add(parameter, reading(reader));
    }

    private Supplier<Value> reading(Function<PioneerState, Value> reader) {
        return known(open -> open.hasSpoken() ? reader.apply(open.state()) : NOTHING_YET);
    }

    private Supplier<Value> known(Function<Session, Value> reader) {
        return () -> {
            Session open = session.get();
            return open == null ? Value.unknown("not connected") : reader.apply(open);
        };
    }
}
