package majic.pioneer;

import java.util.function.Consumer;
import java.util.function.Predicate;
import java.util.function.Supplier;
import majic.bot.BotException;
import majic.bot.TimeSource;
import majic.bot.Value;
import majic.pioneer.arcos.Command;
import org.jspecify.annotations.Nullable;

/** What can be switched on a Pioneer without moving it. */
final class Switches {
    private static final double SWITCH_S = 1;

    /** Pairs of duration in 20 ms and MIDI note; 0 is silence. Three rising tones, one second (ARCOS sheet 6.1). */
    private static final byte[] TONES = {10, 72, 5, 0, 10, 76, 5, 0, 20, 79};

    private static final byte[] SILENCE = {1, 0};
    private static final double TONES_S = 1;

    private final Supplier<@Nullable Session> session;
    private final TimeSource time;
    private final Consumer<String> notice;
    private volatile long beepNanos;

    Switches(Supplier<@Nullable Session> session, TimeSource time, Consumer<String> notice) {
        this.session = session;
        this.time = time;
        this.notice = notice;
    }

    void motors(boolean on) {
        if (on) {
            notice.accept("motors on");
        }
        order(Command.ENABLE, on, "the motors", state -> state.motorsOn() == on);
    }

    void sonar(boolean on) {
        order(Command.SONAR, on, "the sonars", state -> state.sonarOn() == on);
    }

    private void order(Command command, boolean on, String what, Predicate<PioneerState> done) {
        Session open = open();
        open.send(command.packet(on ? 1 : 0));
        if (!open.awaitState(done, SWITCH_S)) {
            throw new BotException(
                    what + " did not switch " + (on ? "on" : "off") + " within " + (int) SWITCH_S + " s");
        }
    }

    void beep(boolean on) {
        open().send(Command.SAY.packet(on ? TONES : SILENCE));
        beepNanos = on ? time.nanos() : 0;
    }

    Value beeping() {
        long started = beepNanos;
        return Value.onOff(started != 0 && time.secondsSince(started) < TONES_S);
    }

    private Session open() {
        Session open = session.get();
        if (open == null) {
            throw new BotException("not connected");
        }
        return open;
    }
}
