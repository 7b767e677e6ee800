package majic.shared.desk;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Objects;
import java.util.OptionalLong;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Predicate;
import majic.environment.BotEnvironment;
import majic.environment.Settings;
import majic.shared.broker.BrokerMessage;
import majic.shared.broker.ConnectOptions;
import majic.shared.broker.FakeConnection;
import majic.shared.broker.Quality;
import majic.shared.message.HoldMessage;
import majic.shared.message.Request;
import majic.shared.message.RequestReply;
import majic.shared.message.RequestedAction;
import majic.shared.message.RobotState;
import majic.shared.message.Sender;
import majic.shared.message.SiteTopics;
import majic.shared.message.SiteTopics.Part;
import majic.shared.message.SpeedMessage;
import majic.shared.message.StopMessage;
import majic.time.Signal;
import org.jspecify.annotations.Nullable;

/** A small program that uses the robots of a desk through the broker, as one in another language would. */
final class RemoteUser {
    private static final double BEAT_S = 0.25;

    final Sender sender;
    final FakeConnection connection;
    private final SharingRig rig;
    private final SiteTopics topics = new SiteTopics(SharingRig.SITE);
    private final List<Answered> answers = new CopyOnWriteArrayList<>();
    private volatile @Nullable RobotState state;
    private volatile long stateNanos;
    private final Signal ended;
    private volatile boolean beating;
    private long numbers;

    private record Answered(String correlation, BrokerMessage message) {}

    RemoteUser(SharingRig rig, String desk, String person) {
        this.rig = rig;
        this.ended = rig.clock.time().signal();
        this.sender = Sender.ofThisRun(desk, person);
        this.connection = rig.broker.open(ConnectOptions.of(
                desk + "-" + sender.session(), new BotEnvironment(rig.clock.time(), Settings.inMemory())));
        connection.subscribe(topics.replies(sender.sessionHash()), Quality.AT_LEAST_ONCE, this::answered);
        connection.subscribe(topic(1, Part.STATE), Quality.AT_MOST_ONCE, message -> {
            if (message.payload().length > 0) {
                stateNanos = rig.clock.time().nanos();
                state = RobotState.parse(message.payload());
            }
        });
        connection.connect();
        rig.clock.until(() -> state != null);
    }

    private void answered(BrokerMessage message) {
        byte[] correlation = Objects.requireNonNull(message.correlation());
        answers.add(new Answered(new String(correlation, StandardCharsets.UTF_8), message));
    }

    String topic(int robot, Part part) {
        return topics.robot(SharingRig.DESK, robot, part);
    }

    RobotState state() {
        return Objects.requireNonNull(state);
    }

    /** The clock of the desk, as far as this program can tell. */
    long clockMs() {
        return state().clock() + Math.round(rig.clock.time().secondsSince(stateNanos) * 1000);
    }

    /** Sends heartbeats from now on. */
    RemoteUser beat() {
        beating = true;
        rig.clock.aside(() -> {
            while (beating) {
                beatOnce();
                pause();
            }
        });
        return this;
    }

    private void pause() {
        try {
            ended.await(() -> !beating, BEAT_S);
        } catch (InterruptedException e) {
            beating = false;
        }
    }

    void beatOnce() {
        if (connection.isConnected()) {
            publish(Part.HOLD, new HoldMessage(sender, clockMs() + 700).toJson(), Quality.AT_MOST_ONCE, "");
        }
    }

    void stopBeating() {
        beating = false;
        ended.raise();
    }

    /** Sends a request to robot 1; returns its number. */
    long ask(RequestedAction action) {
        return ask(++numbers, OptionalLong.of(clockMs() + 1000), action);
    }

    long ask(long number, OptionalLong validUntil, RequestedAction action) {
        numbers = Math.max(numbers, number);
        publish(
                Part.REQUEST,
                new Request(sender, number, validUntil, action).toJson(),
                Quality.AT_LEAST_ONCE,
                String.valueOf(number));
        return number;
    }

    void move(double mm) {
        ask(new RequestedAction.Move(mm, ""));
    }

    /** Begins a motion of 900 mm, and returns while robot 1 moves. */
    void moveOn() {
        move(900);
        rig.clock.until(() -> rig.bot().state().moving());
    }

    void drive(double mmPerSec) {
        SpeedMessage speed = new SpeedMessage(sender, ++numbers, mmPerSec, 0, clockMs() + 500);
        publish(Part.SPEED, speed.toJson(), Quality.AT_MOST_ONCE, "speed");
    }

    /** Stops robot 1 as a program does that loses messages: twice. */
    void stop() {
        byte[] stop = new StopMessage(sender, numbers, "stop-" + numbers).toJson();
        publish(Part.STOP, stop, Quality.AT_MOST_ONCE, "");
        publish(Part.STOP, stop, Quality.AT_LEAST_ONCE, "stop");
    }

    void publish(Part part, byte[] payload, Quality quality, String correlation) {
        BrokerMessage message = BrokerMessage.json(topic(1, part), payload, quality);
        connection.publish(
                correlation.isEmpty()
                        ? message
                        : message.answeredAt(
                                topics.replies(sender.sessionHash()), correlation.getBytes(StandardCharsets.UTF_8)));
    }

    /** All answers to a request so far. */
    List<RequestReply> replies(Object correlation) {
        return answers.stream()
                .filter(answer -> answer.correlation.equals(String.valueOf(correlation)))
                .map(answer -> RequestReply.parse(answer.message.payload()))
                .toList();
    }

    /** Waits for the last answer to a request. */
    RequestReply outcome(Object correlation) {
        rig.clock.until(() -> replies(correlation).stream().anyMatch(reply -> !reply.isFirst()));
        return replies(correlation).stream()
                .filter(reply -> !reply.isFirst())
                .findFirst()
                .orElseThrow();
    }

    /** Waits until the newest state fulfils a condition. */
    void until(Predicate<RobotState> condition) {
        rig.clock.until(() -> condition.test(state()));
    }
}
