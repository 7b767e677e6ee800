package majic.mavlink.session;

import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.IntFunction;
import majic.bot.MotionFailed;
import majic.driver.Motion;
import majic.mavlink.frame.OutgoingMessage;
import majic.mavlink.message.CommandAck;
import majic.mavlink.message.MavlinkRequests;
import majic.time.TimeSource;

/**
 * Sends commands and awaits their answers, which have no number: an answer belongs to the newest command of its kind.
 * Thread-safe.
 */
public final class CommandSender {
    /** Without an answer a command is sent again after this time, seconds (MAVLink sheet 8). */
    private static final double ANSWER_S = 1.5;

    private static final int TIMES = 3;

    /** After the answer that a command is in progress, another one comes within this time, seconds. */
    private static final double PROGRESS_S = 3;

    /** A command that takes longer counts as not done, seconds. */
    private static final double LONGEST_S = 30;

    /** The texts that explain a refusal come this long after it at most, seconds. */
    private static final double REASON_S = 0.3;

    private final VehicleSession session;
    private final TimeSource time;
    private final Map<Integer, Received<CommandAck>> answers = new ConcurrentHashMap<>();

    CommandSender(VehicleSession session, TimeSource time) {
        this.session = session;
        this.time = time;
    }

    /** Takes an answer; on the reader thread. */
    void take(CommandAck answer) {
        answers.put(answer.command(), new Received<>(answer, time.nanos()));
    }

    /**
     * Returns the final answer to a command.
     *
     * @param sinceNanos when it was sent
     * @return empty if there is none yet
     */
    public Optional<CommandAck> answer(int command, long sinceNanos) {
        return Optional.ofNullable(answers.get(command))
                .filter(answer -> answer.atNanos() >= sinceNanos)
                .map(Received::value)
                .filter(answer -> !answer.isInProgress());
    }

    /**
     * Returns whether the autopilot is still at a command, so that a final answer is to come and the command must not
     * be sent again.
     *
     * @param sinceNanos when it was sent
     */
    public boolean isInProgress(int command, long sinceNanos) {
        return progress(command, sinceNanos)
                .filter(answer ->
                        time.secondsSince(answer.atNanos()) < PROGRESS_S && time.secondsSince(sinceNanos) < LONGEST_S)
                .isPresent();
    }

    private Optional<Received<CommandAck>> progress(int command, long sinceNanos) {
        return Optional.ofNullable(answers.get(command))
                .filter(answer -> answer.atNanos() >= sinceNanos)
                .filter(answer -> answer.value().isInProgress());
    }

    /**
     * Sends a command until it is answered, three times at most. One that is in progress is not sent again, and takes
     * 30 s at most.
     *
     * @param what it does, for the message: "arm"
     * @return whether it was accepted; false if the guard of the motion ended it
     * @throws MotionFailed if it was refused, with the reasons of the autopilot, or is not answered or not finished
     */
    public boolean run(Motion motion, String what, int command, double... parameters) {
        return run(
                motion, what, command, times -> MavlinkRequests.command(session.system(), command, times, parameters));
    }

    /** Sends a command in any form; otherwise as the other method. */
    public boolean run(Motion motion, String what, int command, IntFunction<OutgoingMessage> message) {
        long from = time.nanos();
        for (int times = 0; times < TIMES; times++) {
            int before = times;
            motion.send(() -> session.send(message.apply(before)));
            boolean begun = motion.await(() -> answers(command, from), ANSWER_S);
            while (begun && isInProgress(command, from)) {
                if (!motion.await(() -> !isInProgress(command, from), PROGRESS_S) && motion.guardReached()) {
                    return false;
                }
            }
            if (answer(command, from).isPresent()) {
                failIfRefused(motion, what, command, from);
                return true;
            }
            if (motion.guardReached()) {
                return false;
            }
            if (begun) {
                throw new MotionFailed("the autopilot does not finish the command to " + what);
            }
        }
        throw new MotionFailed("the autopilot does not answer the command to " + what);
    }

    private boolean answers(int command, long from) {
        return answer(command, from).isPresent() || progress(command, from).isPresent();
    }

    private void failIfRefused(Motion motion, String what, int command, long from) {
        CommandAck answer = answer(command, from).orElseThrow();
        if (!answer.isAccepted()) {
            motion.pause(REASON_S);
            throw new MotionFailed("the autopilot refuses to " + what + " (" + answer.title() + ")"
                    + session.texts().reasonsSince(from));
        }
    }
}
