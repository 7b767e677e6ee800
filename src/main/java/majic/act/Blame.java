package majic.act;

import java.util.stream.Stream;
import majic.bot.BotException;

/** Puts into words for an act's author what his act failed by. */
final class Blame {
    private Blame() {}

    /** The robots' own complaints speak for themselves; anything else is a mistake in the act, and said with its place. */
    static String of(MajicAct act, Throwable failure) {
        if (failure instanceof BotException) {
            return String.valueOf(failure.getMessage());
        }
        String what = failure.getClass().getSimpleName();
        String message = failure.getMessage();
        return what + (message == null ? "" : ": " + message) + place(act.getClass(), failure);
    }

    private static String place(Class<?> act, Throwable failure) {
        return Stream.of(failure.getStackTrace())
                .filter(frame -> isOf(act, frame.getClassName()) && frame.getLineNumber() > 0)
                .findFirst()
                .map(frame -> " (" + frame.getFileName() + ", line " + frame.getLineNumber() + ")")
                .orElse("");
    }

    private static boolean isOf(Class<?> act, String frame) {
        String outermost = act.getName().replaceFirst("\\$.*", "");
        return frame.equals(outermost) || frame.startsWith(outermost + "$");
    }
}
