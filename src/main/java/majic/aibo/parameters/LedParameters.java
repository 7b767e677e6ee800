package majic.aibo.parameters;

import java.util.ArrayList;
import java.util.List;
import majic.aibo.body.LedNames;
import majic.aibo.urbi.UrbiCommands;
import majic.aibo.urbi.UrbiVersion;
import majic.bot.Parameter;
import majic.bot.Unit;
import majic.bot.Value;
import majic.driver.ParameterTable;
import majic.driver.ParameterTheme;

/** The 26 LEDs, alone and in groups (URBI sheet 13). None of it moves the dog. */
final class LedParameters implements ParameterTheme<UrbiVersion> {
    private static final List<String> PLACES = List.of("front", "middle", "rear");

    private final AiboAccess access;
    private volatile List<Value> former = List.of();
    private volatile boolean lit;

    LedParameters(AiboAccess access) {
        this.access = access;
    }

    @Override
    public void describe(ParameterTable table, UrbiVersion version) {
        LedNames.FACE.forEach(led -> describe(table, led, "brightness of this LED of the face"));
        for (int place = 0; place < PLACES.size(); place++) {
            String where = "brightness of the back's %s LED, " + PLACES.get(place);
            describe(table, LedNames.BACK_COLOUR.get(place), String.format(where, "coloured"));
            describe(table, LedNames.BACK_WHITE.get(place), String.format(where, "white"));
        }
        describeSwitch(table, "ledHC", "the head's coloured LED");
        describeSwitch(table, "ledHW", "the head's white LED");
        describeSwitch(table, "modeR", "red in the mode indicator");
        describeSwitch(table, "modeG", "green in the mode indicator");
        describeSwitch(table, "modeB", "blue in the mode indicator");
        describeSwitch(table, "ledWIFI", "the LED of the wireless network");
        describeGroup(table, "ledF", LedNames.FACE, "the face's LEDs");
        describeGroup(table, "ledBC", LedNames.BACK_COLOUR, "the back's coloured LEDs from the front");
        describeGroup(table, "ledBW", LedNames.BACK_WHITE, "the back's white LEDs from the front");
        describeGroup(
                table, "leds", LedNames.all(), "all 26 LEDs: face, back coloured, back white, head, mode, wireless");
        table.add(Parameter.onOff("light", "lights the face, to find out which robot this is"), () -> Value.onOff(lit))
                .writes(values -> light(values.get(0).isYes()));
    }

    private void describe(ParameterTable table, String led, String help) {
        table.add(brightness(led, help), access.asked(led + ".val", amount -> Value.of(amount, Unit.NONE)))
                .writes(values -> put(List.of(led), values));
    }

    private void describeSwitch(ParameterTable table, String led, String help) {
        table.add(Parameter.onOff(led, help), access.asked(led + ".val", amount -> Value.onOff(amount > 0)))
                .writes(values -> put(List.of(led), values));
    }

    private void describeGroup(ParameterTable table, String group, List<String> leds, String help) {
        Parameter list = Parameter.list(group, Unit.NONE, help + "; set takes one brightness for all, or one for each")
                .within(0, 1);
        for (String led : leds.subList(1, leds.size())) {
            list = list.with(brightness(led, "brightness"));
        }
        table.add(list, access.askedAll(values(leds), Unit.NONE)).writes(values -> {
            if (values.size() == 1) {
                access.send(List.of(UrbiCommands.toGroup(
                        UrbiCommands.assign(group, values.get(0).number()))));
            } else {
                put(leds, values);
            }
        });
    }

    private static Parameter brightness(String name, String help) {
        return Parameter.number(name, Unit.NONE, help).within(0, 1);
    }

    private static List<String> values(List<String> leds) {
        return leds.stream().map(led -> led + ".val").toList();
    }

    /** Sets the first LEDs to as many values as there are; what has no number stays. */
    private void put(List<String> leds, List<Value> values) {
        List<String> commands = new ArrayList<>();
        for (int index = 0; index < values.size(); index++) {
            Value value = values.get(index);
            if (!(value instanceof Value.Unknown)) {
                commands.add(UrbiCommands.assign(leds.get(index) + ".val", value.number()));
            }
        }
        access.send(commands);
    }

    /** Lights the whole face; off gives each LED back what it showed before. */
    private void light(boolean on) {
        if (on == lit) {
            return;
        }
        if (on) {
            former = access.ask(values(LedNames.FACE), amount -> Value.of(amount, Unit.NONE));
            access.send(List.of(UrbiCommands.toGroup("ledF = 1")));
        } else {
            put(LedNames.FACE, former);
        }
        lit = on;
    }
}
