package majic.figures.nav;

import java.lang.instrument.Instrumentation;
import java.lang.management.ManagementFactory;
import majic.time.TimeSource;
import net.bytebuddy.agent.builder.AgentBuilder;
import net.bytebuddy.asm.Advice;
import net.bytebuddy.matcher.ElementMatchers;

/**
 * Notes in a running program when a slower speed than before was given to a driver and when the first bytes were
 * written to a link after that, and what the decisions of a course take of a processor. All methods are thread-safe.
 */
public final class ReactionProbe {
    /** A speed counts as another one if it differs by more, as a share. */
    private static final double SHARE = 0.1;

    private static TimeSource time = TimeSource.system();
    private static double speed;
    private static double decidingS;
    private static boolean armed;
    private static boolean slower;
    private static long writtenNanos;

    private ReactionProbe() {}

    /** Puts the notes into the drivers and links whose classes are loaded from now on. */
    static void install(Instrumentation instrumentation) {
        new AgentBuilder.Default()
                .disableClassFormatChanges()
                .type(ElementMatchers.named("majic.pioneer.MajicPioneer")
                        .or(ElementMatchers.named("majic.ros.MajicRos")))
                .transform((builder, type, loader, module, domain) -> builder.visit(
                                Advice.to(Driving.class).on(ElementMatchers.named("driveAt")))
                        .visit(Advice.to(Halting.class).on(ElementMatchers.named("halt"))))
                .type(ElementMatchers.named("majic.link.TcpLink"))
                .transform((builder, type, loader, module, domain) ->
                        builder.visit(Advice.to(Writing.class).on(ElementMatchers.named("write"))))
                .type(ElementMatchers.named("majic.nav.GoalCourse"))
                .transform((builder, type, loader, module, domain) ->
                        builder.visit(Advice.to(Deciding.class).on(ElementMatchers.named("next"))))
                .installOn(instrumentation);
    }

    /** Is copied into the method that drives. */
    public static final class Driving {
        private Driving() {}

        /** Is called first. */
        @Advice.OnMethodEnter
        public static void enter(@Advice.Argument(0) double mmPerSec) {
            driven(mmPerSec);
        }
    }

    /** Is copied into the method that stops. */
    public static final class Halting {
        private Halting() {}

        /** Is called first. */
        @Advice.OnMethodEnter
        public static void enter() {
            driven(0);
        }
    }

    /** Is copied into the method that writes to a link. */
    public static final class Writing {
        private Writing() {}

        /** Is called first. */
        @Advice.OnMethodEnter
        public static void enter() {
            written();
        }
    }

    /** Is copied into the method that decides. */
    public static final class Deciding {
        private Deciding() {}

        /** Is called first. */
        @Advice.OnMethodEnter
        public static long enter() {
            return cpuNanos();
        }

        /** Is called last. */
        @Advice.OnMethodExit(onThrowable = Throwable.class)
        public static void exit(@Advice.Enter long beganNanos) {
            decided(cpuNanos() - beganNanos);
        }
    }

    /** Returns what the thread has taken of a processor, ns. */
    public static long cpuNanos() {
        return ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime();
    }

    /** Notes a speed, mm/s. */
    public static synchronized void driven(double mmPerSec) {
        slower |= armed && mmPerSec < speed * (1 - SHARE);
        speed = mmPerSec;
    }

    /** Notes that bytes are written. */
    public static synchronized void written() {
        if (slower && writtenNanos < 0) {
            writtenNanos = time.nanos();
        }
    }

    /** Notes what a decision took; the one before the slower speed counts. */
    public static synchronized void decided(long nanos) {
        if (armed && !slower) {
            decidingS = nanos / 1e9;
        }
    }

    /** Uses the clock of a lab. */
    static synchronized void use(TimeSource clock) {
        time = clock;
    }

    /** A report has shown an obstacle: notes the first slower speed from now on. */
    static synchronized void arm() {
        armed = true;
        slower = false;
        writtenNanos = -1;
    }

    static synchronized void disarm() {
        armed = false;
        slower = false;
    }

    /** Returns when the first bytes after a slower speed were written, ns of the clock; -1 if there were none. */
    static synchronized long writtenNanos() {
        return slower ? writtenNanos : -1;
    }

    /** Returns what the decision for it took of a processor, s. */
    static synchronized double decidingS() {
        return decidingS;
    }
}
