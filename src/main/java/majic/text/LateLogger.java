package majic.text;

import java.util.ResourceBundle;
import org.jspecify.annotations.Nullable;

/**
 * A logger that the JDK creates with the first line. The JDK's first logger initialises its logging, which would delay
 * the window, so classes that are needed for the first painting use this one. Thread-safe.
 */
public final class LateLogger implements System.Logger {
    private final String name;
    private volatile System.@Nullable Logger created;

    private LateLogger(String name) {
        this.name = name;
    }

    /**
     * Returns a logger with the name of a class; creates none in the JDK yet.
     *
     * @param user the class that logs
     * @return the logger
     */
    public static System.Logger of(Class<?> user) {
        return new LateLogger(user.getName());
    }

    private System.Logger logger() {
        System.Logger logger = created;
        if (logger == null) {
            logger = System.getLogger(name);
            created = logger;
        }
        return logger;
    }

    @Override
    public String getName() {
        return name;
    }

    @Override
    public boolean isLoggable(Level level) {
        return logger().isLoggable(level);
    }

    @Override
    public void log(Level level, @Nullable ResourceBundle texts, @Nullable String message, @Nullable Throwable thrown) {
        logger().log(level, texts, message, thrown);
    }

    @Override
    public void log(
            Level level,
            @Nullable ResourceBundle texts,
            @Nullable String format,
            @Nullable Object @Nullable ... values) {
        logger().log(level, texts, format, values);
    }
}
