package majic.link;

import java.io.IOException;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;

/** Waits a limited time for a call that the system may block without limit, such as the look-up of a name. */
final class TimedCall {
    private TimedCall() {}

    /**
     * Makes a call on a thread of its own, which continues if the call takes too long.
     *
     * @throws IOException what the call threw
     * @throws TimeoutException if the call did not return in time
     */
    static <T> T call(String what, long timeoutMs, Callable<T> blocking) throws IOException, TimeoutException {
        FutureTask<T> task = new FutureTask<>(blocking);
        Thread thread = new Thread(task, what);
        thread.setDaemon(true);
        thread.start();
        try {
            return task.get(timeoutMs, TimeUnit.MILLISECONDS);
        } catch (ExecutionException e) {
            throw e.getCause() instanceof IOException failure
                    ? failure
                    : new IOException(what + " failed", e.getCause());
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new IOException("interrupted while " + what, e);
        }
    }
}
