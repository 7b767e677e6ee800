package majic.program;

import org.jspecify.annotations.Nullable;

/**
 * Reports that a plug-in, or one of its types of robots, cannot be used. The message is half a sentence for the user.
 */
final class PluginProblem extends Exception {
    private static final long serialVersionUID = 1;

    PluginProblem(String message) {
        this(message, null);
    }

    PluginProblem(String message, @Nullable Throwable cause) {
        super(message, cause);
    }
}
