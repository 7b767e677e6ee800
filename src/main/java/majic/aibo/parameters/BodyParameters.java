package majic.aibo.parameters;

import java.util.List;
import majic.aibo.body.Posture;
import majic.aibo.body.Sensor;
import majic.aibo.body.SensorReadings;
import majic.aibo.session.AiboSession;
import majic.aibo.urbi.UrbiValue;
import majic.aibo.urbi.UrbiVersion;
import majic.bot.BotException;
import majic.bot.Parameter;
import majic.bot.Value;
import majic.driver.Motion;
import majic.driver.ParameterTable;
import majic.driver.ParameterTheme;
import majic.time.WaitPolicy;

/** The dog as a whole: posture, motors, what it is. */
final class BodyParameters implements ParameterTheme<UrbiVersion> {
    private static final double ASK_S = 4;

    private final AiboAccess access;
    private final SensorReadings senses;

    BodyParameters(AiboAccess access) {
        this.access = access;
        this.senses = access.senses();
    }

    @Override
    public void describe(ParameterTable table, UrbiVersion version) {
        table.add(Parameter.choice("posture", Posture.words(), "how it stands, sits or lies"), this::posture)
                .moves(this::take);
        table.add(
                        Parameter.yesNo("motors", "whether the legs are stiff; off lays it down first"),
                        () -> senses.motorsOn().map(Value::yesNo).orElseGet(() -> senses.unknown(Sensor.LEG_LOAD)))
                .moves(this::power);
        table.add(Parameter.text("version", "the URBI in the dog"), this::version);
    }

    private Value posture() {
        if (WaitPolicy.isAllowed()) {
            return Value.text(access.open().postures().posture());
        }
        String reported = senses.posture();
        return reported == null ? senses.unknown(Sensor.POSTURE) : Value.text(reported);
    }

    private void take(List<Value> values, Motion motion) {
        access.open().postures().take(Posture.of(values.get(0).toString()), motion);
        access.open().sweep().home(0);
    }

    private void power(List<Value> values, Motion motion) {
        if (values.get(0).isYes()) {
            access.open().postures().power(motion);
        } else {
            access.open().postures().loosen(motion);
        }
    }

    private Value version() {
        AiboSession open = access.open();
        UrbiVersion version = open.connections().sensors().version();
        String urbi = version == UrbiVersion.V1_5 ? "URBI 1.5" : "URBI 1.0";
        try {
            return open.questions().ask(open.connections().sensors(), "system.name", ASK_S)
                            instanceof UrbiValue.Str name
                    ? Value.text(name.text() + ", " + urbi)
                    : Value.text(urbi);
        } catch (BotException e) {
            return Value.text(urbi);
        }
    }
}
