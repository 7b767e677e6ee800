package majicsim.aibo;

import java.util.Set;

/** The speaker: it takes every sound and is done with it at once (URBI sheet, sections 12 and 13). */
final class Speaker {
    private static final Set<String> FILES =
            Set.of("bark", "bark2", "beep", "start", "client", "welcome", "battery", "drum1", "test", "tecno");

    void install(Kernel kernel) {
        Variable sound = new Variable("speaker.val", Value.VOID);
        sound.properties().blend(Blend.MIX);
        kernel.variables().put(sound);
        kernel.variables().put(new Variable("speaker.playing", Value.of(0)));
        kernel.variables().put(new Variable("speaker.remain", Value.of(0)));
        kernel.functions().builtIn("speaker.play", arguments -> {
            String file = arguments.isEmpty() ? "" : Operators.text(arguments.get(0));
            return Value.of(FILES.contains(file.replaceFirst("\\.wav$", "")));
        });
    }
}
