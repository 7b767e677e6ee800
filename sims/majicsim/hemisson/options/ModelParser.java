package majicsim.hemisson.options;

import java.util.EnumSet;
import java.util.Locale;
import java.util.Set;
import majicsim.hemisson.modules.ModuleKind;

/** Parses the words of a model, one after the other. */
final class ModelParser {
    static final String KNOWN =
            "kteam or roadnarrows, then +camera +ultrasonic +speech +lcd +io +overrun +paced +switches=1111 +ambient=220"
                    + " +mismatch=0";

    private ModelParser() {}

    static HemissonOptions parse(String model) {
        String[] words = model.toLowerCase(Locale.ROOT).split("\\+", -1);
        HemissonOptions options = HemissonOptions.standard().withDialect(dialect(words[0]));
        for (int i = 1; i < words.length; i++) {
            options = with(options, words[i]);
        }
        return options;
    }

    private static Dialect dialect(String word) {
        return switch (word) {
            case "kteam" -> Dialect.KTEAM;
            case "roadnarrows" -> Dialect.ROADNARROWS;
            default -> throw unknown(word);
        };
    }

    private static HemissonOptions with(HemissonOptions options, String word) {
        int equals = word.indexOf('=');
        if (equals >= 0) {
            return with(options, word.substring(0, equals), word.substring(equals + 1));
        }
        return switch (word) {
            case "camera" -> plus(options, ModuleKind.CAMERA);
            case "ultrasonic" -> plus(options, ModuleKind.ULTRASONIC);
            case "speech" -> plus(options, ModuleKind.SPEECH);
            case "lcd" -> plus(options, ModuleKind.LCD);
            case "io" -> plus(options, ModuleKind.IO);
            case "overrun" -> options.withOverrun();
            case "paced" -> options.paced();
            default -> throw unknown(word);
        };
    }

    private static HemissonOptions with(HemissonOptions options, String word, String value) {
        try {
            return switch (word) {
                case "switches" -> options.withSwitches(value);
                case "ambient" -> options.withAmbient(Integer.parseInt(value));
                case "mismatch" -> options.withMismatch(Double.parseDouble(value));
                default -> throw unknown(word);
            };
        } catch (NumberFormatException e) {
            throw new IllegalArgumentException(word + " must be a number, not '" + value + "'", e);
        }
    }

    private static HemissonOptions plus(HemissonOptions options, ModuleKind module) {
        Set<ModuleKind> all = EnumSet.of(module);
        all.addAll(options.modules());
        return options.withModules(all);
    }

    private static IllegalArgumentException unknown(String word) {
        return new IllegalArgumentException("there is no '" + word + "' for a Hemisson; known are " + KNOWN);
    }
}
