package majic.aibo.parameters;

import java.util.List;
import majic.aibo.urbi.UrbiCommands;
import majic.aibo.urbi.UrbiVersion;
import majic.bot.Parameter;
import majic.bot.Unit;
import majic.bot.Value;
import majic.driver.ParameterTable;
import majic.driver.ParameterTheme;

/** How the camera takes its pictures, in words where the dog has numbers (URBI sheet 13). */
final class CameraParameters implements ParameterTheme<UrbiVersion> {
    private static final int BEST = 100;

    private final AiboAccess access;

    CameraParameters(AiboAccess access) {
        this.access = access;
    }

    @Override
    public void describe(ParameterTable table, UrbiVersion version) {
        words(table, "format", "format", 0, List.of("YCbCr", "jpeg"), "how the camera's pictures are sent");
        words(
                table,
                "resolution",
                "resolution",
                0,
                List.of("full", "half", "quarter"),
                "how fine the camera's pictures are: 208 × 160 pixels, 104 × 80 or 52 × 40");
        table.add(
                        Parameter.number("jpegFactor", Unit.NONE, "quality of the camera's jpeg pictures")
                                .within(0, BEST),
                        access.asked("camera.jpegfactor", amount -> Value.of(amount, Unit.NONE)))
                .writes(values -> assign("jpegfactor", Math.rint(values.get(0).number())));
        words(table, "shutter", "shutter", 1, List.of("slow", "mid", "fast"), "the camera's shutter");
        words(table, "gain", "gain", 1, List.of("low", "mid", "high"), "how much the camera amplifies the light");
        words(
                table,
                "whiteBalance",
                "wb",
                1,
                List.of("indoor", "outdoor", "fluorescent"),
                "the light that the camera takes for white");
        table.add(
                        Parameter.onOff("reconstruct", "whether the camera rebuilds the fine picture, which is slow"),
                        access.asked("camera.reconstruct", amount -> Value.onOff(amount > 0)))
                .writes(values -> assign("reconstruct", values.get(0).number()));
    }

    /** A setting that the dog counts from a number on. */
    private void words(ParameterTable table, String name, String field, int first, List<String> words, String help) {
        table.add(
                        Parameter.choice(name, words, help),
                        access.asked("camera." + field, amount -> word(words, (int) Math.rint(amount) - first)))
                .writes(values ->
                        assign(field, first + words.indexOf(values.get(0).toString())));
    }

    private static Value word(List<String> words, int index) {
        return index >= 0 && index < words.size()
                ? Value.text(words.get(index))
                : Value.unknown("a setting that the dog's manual does not name");
    }

    private void assign(String field, double amount) {
        access.send(List.of(UrbiCommands.assign("camera." + field, amount)));
    }
}
