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
import majic.hemisson.readings.RobotReadings;

/**
 * The camera of one line of 102 pixels (Hemisson sheet 9 and 10). Reading it occupies the line for up to 37 ms, so it
 * is refused while the robot moves.
 */
final class LinearCamera implements ExtensionModule {
    private static final int ADDRESS = 0xC0;
    private static final int PIXELS = 102;

    private final Row pixels;
    private final Row thresholded;
    private final ModuleNumber exposure;
    private final ModuleNumber threshold;
    private final LightSwitching light;

    /** A reading of all pixels. */
    private record Row(Question ask, Function<Reply, List<Integer>> values) {
        static Row registers(int first) {
            return new Row(Bus.read(ADDRESS, first, PIXELS), Reply::numbers);
        }

        /** Two hex digits a pixel, run together. */
        static Row roadNarrows(char letter) {
            String head = "a,L," + letter + ",0,";
            return new Row(
                    Question.ask(
                            "A,L," + letter + ",0",
                            head + "([0-9A-Fa-f]{2}){" + PIXELS + "}",
                            Question.msFor(head.length() + 2 * PIXELS)),
                    reply -> fromHex(reply.text().substring(head.length())));
        }

        private static List<Integer> fromHex(String digits) {
            List<Integer> values = new ArrayList<>();
            for (int at = 0; at < digits.length(); at += 2) {
                values.add(Integer.parseInt(digits.substring(at, at + 2), 16));
            }
            return values;
        }
    }

    /** Adds the parameter that switches its light. */
    private interface LightSwitching {
        void describe(ParameterTable table, RobotReadings access, Parameter parameter);
    }

    private LinearCamera(
            Row pixels, Row thresholded, ModuleNumber exposure, ModuleNumber threshold, LightSwitching light) {
        this.pixels = pixels;
        this.thresholded = thresholded;
        this.exposure = exposure;
        this.threshold = threshold;
        this.light = light;
    }

    static LinearCamera stock() {
        return new LinearCamera(
                Row.registers(0x10),
                Row.registers(0x11),
                ModuleNumber.register(ADDRESS, 0x21),
                ModuleNumber.register(ADDRESS, 0x20),
                ModuleNumber.register(ADDRESS, 0x30)::describeSwitch);
    }

    static LinearCamera roadNarrows() {
        return new LinearCamera(
                Row.roadNarrows('P'),
                Row.roadNarrows('Q'),
                ModuleNumber.roadNarrows('L', 'F', 'E'),
                ModuleNumber.roadNarrows('L', 'U', 'T'),
                LinearCamera::roadNarrowsLight);
    }

    /** The firmware can switch the light but cannot report it. */
    private static void roadNarrowsLight(ParameterTable table, RobotReadings access, Parameter parameter) {
        new UnreportedSetting()
                .describe(
                        table,
                        access,
                        parameter,
                        wish -> new UnreportedSetting.Order(
                                Question.ask("A,L,L," + (wish.isYes() ? 1 : 0), "a,L,L(,.*)?", Question.msFor(8)),
                                wish));
    }

    @Override
    public void describe(ParameterTable table, RobotReadings access) {
        row(table, access, "camera", pixels, "its pixels from left to right, 0 to 255; not while it moves");
        row(table, access, "cameraThresholded", thresholded, "the same, each pixel dark or bright; not while it moves");
        exposure.describe(
                table,
                access,
                Parameter.number("cameraExposure", Unit.MS, "how long the camera gathers light")
                        .within(1, 255));
        threshold.describe(
                table,
                access,
                Parameter.number("cameraThreshold", Unit.NONE, "from which value a pixel counts as bright")
                        .within(0, 255));
        light.describe(table, access, Parameter.onOff("cameraLight", "the light of the camera"));
    }

    private static void row(ParameterTable table, RobotReadings access, String name, Row row, String help) {
        table.add(
                Parameter.list(name, Unit.NONE, help),
                access.asked(
                        row.ask(),
                        reply -> Value.many(row.values().apply(reply).stream()
                                .map(RobotReadings::count)
                                .toList())));
    }
}
