package majicsim.aibo.sound;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import majicsim.aibo.urbi.Kernel;
import majicsim.aibo.urbi.memory.Blend;
import majicsim.aibo.urbi.memory.Variable;
import majicsim.aibo.urbi.value.Failure;
import majicsim.aibo.urbi.value.Value;
import org.jspecify.annotations.Nullable;

/** The speaker: a sound that arrives while another plays follows it without a gap (URBI sheet, sections 12 and 13). */
public final class Speaker {
    private static final int KEPT = 100;

    private final Kernel kernel;
    private final Deque<PlayedSound> played = new ArrayDeque<>();

    public Speaker(Kernel kernel) {
        this.kernel = kernel;
    }

    public void install() {
        Variable val = new Variable("speaker.val", Value.VOID, new Variable.Hardware() {
            private Value last = Value.VOID;

            @Override
            public Value measure() {
                return last;
            }

            @Override
            public void receive(Value.Binary binary) {
                last = binary;
                play("sent", Pcm.sound(binary));
            }
        });
        val.blend(Blend.MIX);
        kernel.memory().variables().put(val);
        kernel.memory().variables().put(new Variable("speaker.playing", Value.of(0), () -> Value.of(remainMs() > 0)));
        kernel.memory().variables().put(new Variable("speaker.remain", Value.of(0), () -> Value.of(remainMs())));
        kernel.functions().builtIn("speaker.play", arguments -> Value.of(play(name(arguments))));
        kernel.functions().builtIn("loadwav", arguments -> load(name(arguments)));
    }

    /** Plays a file of the stick; returns false if there is none of that name. */
    boolean play(String file) {
        return play(file, MemoryStickSounds.named(file));
    }

    /** The last sounds, oldest first. */
    public List<PlayedSound> played() {
        return List.copyOf(played);
    }

    /** The output at a sample of lab time, counted from its start. */
    int sample(long index) {
        for (PlayedSound each : played) {
            int value = each.sound().sample((int) (index - Math.round(each.startMs() * Sound.RATE_HZ / 1000)));
            if (value != 0) {
                return value;
            }
        }
        return 0;
    }

    private double remainMs() {
        return Math.max(0, endMs() - kernel.nowMs());
    }

    private double endMs() {
        return played.isEmpty() ? 0 : played.getLast().endMs();
    }

    private boolean play(String what, @Nullable Sound sound) {
        if (sound == null) {
            return false;
        }
        played.add(new PlayedSound(what, Math.max(kernel.nowMs(), endMs()), sound));
        if (played.size() > KEPT) {
            played.removeFirst();
        }
        return true;
    }

    private static Value load(String file) throws Failure {
        Sound sound = MemoryStickSounds.named(file);
        if (sound == null) {
            throw Failure.inExpression("Cannot load the file " + file);
        }
        return new Value.Binary(sound.wav(), "wav");
    }

    private static String name(List<Value> arguments) throws Failure {
        return arguments.isEmpty() ? "" : arguments.get(0).text();
    }
}
