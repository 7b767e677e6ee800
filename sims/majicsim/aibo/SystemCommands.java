package majicsim.aibo;

import java.util.List;
import org.jspecify.annotations.Nullable;

/** The commands of one word (URBI sheet, section 9). */
final class SystemCommands {
    private SystemCommands() {}

    static @Nullable Task run(Context context, String word) {
        switch (word) {
            case "ping" -> context.info("pong time=" + (long) context.kernel().timestampMs());
            case "quit" -> context.connection().quit();
            case "connections" -> context.kernel().connections().forEach(each -> context.info(each.describe()));
            case "devices" -> context.info("devices is deprecated. Use 'group objects' instead.");
            case "motoron" -> renamed(context, "motor on");
            case "motoroff" -> renamed(context, "motor off");
            case "group" -> list(context, List.copyOf(context.kernel().groups().names()));
            case "def" -> list(context, context.kernel().functions().listing());
            case "vars", "uservars" -> list(context, variables(context, word.equals("uservars")));
            case "stopall" -> stopAll(context);
            default -> {
                // What is left has no reply here: noop, strict and what a controller must not send.
            }
        }
        return null;
    }

    private static void renamed(Context context, String today) {
        context.error("This command is no longer valid. Please use \"" + today + "\" instead");
    }

    private static void list(Context context, List<String> lines) {
        lines.forEach(context::info);
    }

    private static List<String> variables(Context context, boolean ownOnly) {
        String own = context.connection().id() + ".";
        return context.kernel().variables().all().stream()
                .filter(variable -> !ownOnly || variable.name().startsWith(own))
                .map(variable -> variable.name() + " = " + variable.read().print())
                .toList();
    }

    private static void stopAll(Context context) {
        context.kernel().connections().forEach(each -> each.stream().clear());
        context.info("All commands cleared");
    }
}
