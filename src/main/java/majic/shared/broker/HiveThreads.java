package majic.shared.broker;

import com.hivemq.client.mqtt.MqttClientExecutorConfig;
import io.reactivex.schedulers.Schedulers;
import java.util.concurrent.Executor;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;

/** The threads of connections: one that reads and writes for all of them, and one for each that calls its handlers. */
final class HiveThreads {
    /**
     * The same object for all connections, so that the client library uses one thread for all; it ends with the last.
     */
    private static final Executor NETWORK = task -> daemon("MQTT network", task).start();

    private HiveThreads() {}

    /** Creates the thread that calls handlers and watchers; it starts with the first task. */
    static ThreadPoolExecutor handlers(BrokerAddress address) {
        ThreadPoolExecutor handlers = new ThreadPoolExecutor(
                1,
                1,
                1,
                TimeUnit.SECONDS,
                new LinkedBlockingQueue<>(),
                task -> daemon("MQTT " + address.hostAndPort(), task),
                new ThreadPoolExecutor.DiscardPolicy());
        handlers.allowCoreThreadTimeOut(true);
        return handlers;
    }

    /** Starts a task that may wait. */
    static void start(String name, Runnable task) {
        daemon(name, task).start();
    }

    /** The threads as the client library takes them; what it completes, it completes on the thread of the network. */
    static MqttClientExecutorConfig config() {
        return MqttClientExecutorConfig.builder()
                .nettyExecutor(NETWORK)
                .nettyThreads(1)
                .applicationScheduler(Schedulers.trampoline())
                .build();
    }

    private static Thread daemon(String name, Runnable task) {
        Thread thread = new Thread(task, name);
        thread.setDaemon(true);
        return thread;
    }
}
