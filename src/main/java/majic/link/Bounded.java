package majic.link;

import java.io.IOException;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;

/** Calls that the system may hold up as long as it likes, such as the look-up of a name, waited for no longer than wanted. */
final class Bounded {
    private Bounded() {}

    /**
     * Makes a call on a thread of its own, which is left behind when it takes too long.
     *
     * @throws IOException what the call threw
     * @throws TimeoutException if it did not come back in time; it goes on
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
