package majic.act;

import java.util.Optional;
import java.util.stream.Stream;
import majic.bot.BotException;
import majic.text.VisibleText;

/** Describes the failure of an act for its author. */
public final class FailureText {
    private FailureText() {}

    /** Returns why {@code behave()} failed, then why {@code ended()} failed; either may be missing. */
    static Optional<String> of(MajicAct act) {
        Throwable failure = act.failure();
        Throwable ending = act.endingFailure();
        if (failure == null) {
            return Optional.ofNullable(ending).map(reason -> ofEnding(act, reason));
        }
        return Optional.of(of(act, failure) + (ending == null ? "" : "; then " + ofEnding(act, ending)));
    }

    static String ofEnding(MajicAct act, Throwable failure) {
        return "its ended() failed: " + of(act, failure);
    }

    /**
     * Returns the message of a robot's error as it is; any other exception is a defect of the act and is given with its
     * source line.
     */
    static String of(MajicAct act, Throwable failure) {
        if (failure instanceof BotException) {
            return String.valueOf(failure.getMessage());
        }
        return named(failure) + place(act.getClass(), failure);
    }

    /** Returns the kind of the exception and its message, in one line. */
    public static String named(Throwable failure) {
        String message = failure.getMessage();
        return VisibleText.of(failure.getClass().getSimpleName() + (message == null ? "" : ": " + message));
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
