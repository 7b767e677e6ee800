package majic.figures.ways;

import java.lang.instrument.Instrumentation;
import java.util.ArrayList;
import java.util.List;
import net.bytebuddy.agent.builder.AgentBuilder;
import net.bytebuddy.asm.Advice;
import net.bytebuddy.matcher.ElementMatchers;

/** Records every entry into a method or constructor of {@code majic}, in the order of the calls of all threads. */
final class CallRecord {
    private static final List<Call> CALLS = new ArrayList<>();

    private CallRecord() {}

    /**
     * An entry into a method.
     *
     * @param thread the name of the thread
     * @param type the outermost class around it, with its package
     * @param method its name
     */
    record Call(String thread, String type, String method) {
        /** Whether it is a mark of the program that measures. */
        boolean isMark(String name) {
            return type.isEmpty() && method.equals(name);
        }

        boolean isWrite() {
            return type.startsWith("majic.link.") && method.equals("write");
        }

        boolean isRead() {
            return type.startsWith("majic.link.") && method.equals("read");
        }
    }

    /** What is called first in each method. */
    public static final class Entry {
        private Entry() {}

        /** Is copied into the methods. */
        @Advice.OnMethodEnter
        public static void enter(@Advice.Origin("#t") String type, @Advice.Origin("#m") String method) {
            CallProbe.entered(type, method);
        }
    }

    /** Records the calls of all classes that are loaded from now on. */
    static void install(Instrumentation instrumentation) {
        CallProbe.receiver = CallRecord::add;
        new AgentBuilder.Default()
                .disableClassFormatChanges()
                .type(ElementMatchers.nameStartsWith("majic.")
                        .and(ElementMatchers.not(ElementMatchers.nameStartsWith("majic.figures.")))
                        .and(ElementMatchers.not(ElementMatchers.nameStartsWith("majic.simulation."))))
                .transform((builder, type, loader, module, domain) -> builder.visit(Advice.to(Entry.class)
                        .on(ElementMatchers.isMethod()
                                .or(ElementMatchers.isConstructor())
                                .and(ElementMatchers.not(ElementMatchers.isAbstract())))))
                .installOn(instrumentation);
    }

    /** Adds a mark of the program that measures. */
    static void mark(String name) {
        add("", name);
    }

    private static void add(String type, String method) {
        int nested = type.indexOf('$');
        Call call = new Call(Thread.currentThread().getName(), nested < 0 ? type : type.substring(0, nested), method);
        synchronized (CALLS) {
            CALLS.add(call);
        }
    }

    /** Returns all calls since the last time. */
    static List<Call> take() {
        synchronized (CALLS) {
            List<Call> taken = new ArrayList<>(CALLS);
            CALLS.clear();
            return taken;
        }
    }
}
