package majic.bot;

import java.io.IOException;
import java.net.BindException;
import java.net.ConnectException;
import java.net.NoRouteToHostException;
import java.net.SocketTimeoutException;
import java.net.UnknownHostException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.NoSuchFileException;
import java.util.concurrent.TimeoutException;
import org.jspecify.annotations.Nullable;

/** A robot could not be connected. Nothing was moved, and nothing stays open. */
public class ConnectFailed extends BotException {
    private static final long serialVersionUID = 1;

    private final Reason reason;

    /** Why a robot could not be connected. */
    public enum Reason {
        /** There is no computer of that name. */
        UNKNOWN_HOST,
        /** The computer was reached, but nothing listens at that port. */
        REFUSED,
        /** Nothing answered in time: the robot is off, out of reach, or the address is another computer's. */
        NO_ANSWER,
        /** Something answered, but not as this type of robot does. */
        WRONG_DEVICE,
        /** The robot or the serial port is used by another program. */
        BUSY,
        /** There is no serial port of that name. */
        NO_SUCH_PORT,
        /** The name of the robot's serial port is, or may be, that of another adapter now; nothing was sent to it. */
        OTHER_ADAPTER,
        /** The user may not use the serial port. */
        NOT_ALLOWED,
        /** The user name or the password is missing or wrong. */
        WRONG_LOGIN,
        /** Another reason, which the message gives. */
        OTHER
    }

    /**
     * A failure to connect.
     *
     * @param reason the kind of failure
     * @param message what went wrong and what to try
     */
    public ConnectFailed(Reason reason, String message) {
        super(message);
        this.reason = reason;
    }

    /**
     * A failure to connect with its cause.
     *
     * @param reason the kind of failure
     * @param message what went wrong and what to try
     * @param cause the exception of the system; null if there is none
     */
    public ConnectFailed(Reason reason, String message, @Nullable Throwable cause) {
        super(message, cause);
        this.reason = reason;
    }

    /**
     * Explains why a link could not be opened.
     *
     * @param failure its message is for the user, and its causes tell the reason
     * @return the same message with the reason
     */
    public static ConnectFailed of(IOException failure) {
        return of(failure, String.valueOf(failure.getMessage()));
    }

    /**
     * Explains why a link could not be opened, in other words.
     *
     * @param failure its causes tell the reason
     * @param message what went wrong and what to try
     * @return the message with the reason
     */
    public static ConnectFailed of(IOException failure, String message) {
        return new ConnectFailed(reason(failure), message, failure);
    }

    /**
     * Returns why the robot could not be connected.
     *
     * @return the kind of failure
     */
    public Reason reason() {
        return reason;
    }

    private static Reason reason(Throwable failure) {
        Reason reason = Reason.OTHER;
        for (Throwable cause = failure; cause != null && reason == Reason.OTHER; cause = cause.getCause()) {
            reason = ofOne(cause);
        }
        return reason;
    }

    private static Reason ofOne(Throwable cause) {
        if (cause instanceof UnknownHostException) {
            return Reason.UNKNOWN_HOST;
        }
        if (cause instanceof BindException) {
            return Reason.BUSY;
        }
        if (cause instanceof ConnectException) {
            return Reason.REFUSED;
        }
        if (cause instanceof SocketTimeoutException
                || cause instanceof NoRouteToHostException
                || cause instanceof TimeoutException) {
            return Reason.NO_ANSWER;
        }
        if (cause instanceof NoSuchFileException) {
            return Reason.NO_SUCH_PORT;
        }
        if (cause instanceof FileAlreadyExistsException) {
            return Reason.OTHER_ADAPTER;
        }
        if (cause instanceof AccessDeniedException) {
            return Reason.NOT_ALLOWED;
        }
        return cause instanceof FileSystemException ? Reason.BUSY : Reason.OTHER;
    }
}
