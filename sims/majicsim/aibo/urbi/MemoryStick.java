package majicsim.aibo.urbi;

import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import majicsim.aibo.urbi.run.CommandStream;
import majicsim.aibo.urbi.run.Connection;
import majicsim.aibo.urbi.run.Context;
import majicsim.aibo.urbi.run.Functions;
import majicsim.aibo.urbi.run.Task;
import majicsim.aibo.urbi.syntax.CommandReader;
import majicsim.aibo.urbi.syntax.SeparatedStatement;
import majicsim.aibo.urbi.syntax.Statement;
import majicsim.aibo.urbi.value.Failure;
import majicsim.aibo.urbi.value.Value;

/**
 * The files of the memory stick, and the functions that run program text: exec, load and save (URBI sheet, section 9).
 */
public final class MemoryStick {
    /** The stick holds this many characters that programs saved. */
    private static final int MAX_SAVED = 1 << 20;

    private static final String CLIENT = "CLIENT.INI";

    private final Map<String, String> files = new HashMap<>();
    private final String program;
    private int saved;

    /**
     * A stick with what belongs onto it.
     *
     * @param program what runs at the start and after each reset: the dog's own functions
     * @param client what runs in each connection when it comes
     */
    public MemoryStick(String program, String client) {
        this.program = program;
        files.put("motion.u", program);
        files.put("URBI.INI", "load(\"motion.u\"); load(\"custom.u\");");
        files.put("custom.u", "// for scripts of one's own\n");
        files.put(CLIENT, client);
    }

    /**
     * Starts a server with it, once all of its hardware is there.
     *
     * @param kernel the server's, not yet started
     */
    public void insertInto(Kernel kernel) {
        Functions functions = kernel.functions();
        functions.lasting("exec", 1, (context, arguments) -> run(context, shown(arguments.get(0))));
        functions.lasting("load", 1, this::load);
        functions.builtIn("save", this::save);
        kernel.onConnect(this::greet);
        kernel.boot(program);
    }

    /**
     * Runs CLIENT.INI in a connection, from the next cycle on and beside what the client sends (URBI sheet, section 2).
     */
    private void greet(Connection connection) {
        connection.adopt(program(connection.context(), files.getOrDefault(CLIENT, "")));
    }

    private Task load(Context context, List<Value> arguments) throws Failure {
        String name = shown(arguments.get(0));
        String text = files.get(name);
        if (text == null) {
            throw Failure.inExpression("Cannot load the file " + name);
        }
        context.info('"' + name + "\" loaded.");
        return run(context, text);
    }

    private Value save(List<Value> arguments) throws Failure {
        if (arguments.size() != 2) {
            throw Failure.inExpression();
        }
        String name = shown(arguments.get(0));
        String text = shown(arguments.get(1));
        if (saved + name.length() + text.length() > MAX_SAVED) {
            throw Failure.inExpression("Cannot save to the file " + name);
        }
        saved += name.length() + text.length();
        files.put(name, text);
        return Value.VOID;
    }

    private static Task run(Context context, String text) throws Failure {
        if (!context.server().budget().takeText(context.server().pass(), text.length())) {
            throw Failure.of("CPU Overload");
        }
        return program(context, text);
    }

    private static Task program(Context context, String text) {
        byte[] bytes = text.getBytes(StandardCharsets.ISO_8859_1);
        List<SeparatedStatement> steps =
                CommandReader.all(bytes, problem -> context.connection().send("error", "!!! " + problem));
        return new CommandStream(context.inner(Statement.NO_TAG), steps);
    }

    private static String shown(Value value) throws Failure {
        return Value.of(value.text()).show();
    }
}
