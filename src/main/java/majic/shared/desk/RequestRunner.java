package majic.shared.desk;

import java.util.List;
import java.util.OptionalLong;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.BiFunction;
import java.util.function.Consumer;
import majic.bot.BotCommand;
import majic.bot.BotControl;
import majic.bot.BotException;
import majic.bot.Guard;
import majic.bot.LinkLost;
import majic.bot.MajicBot;
import majic.bot.MotionReport;
import majic.bot.MotionStopped;
import majic.shared.broker.BrokerMessage;
import majic.shared.message.Request;
import majic.shared.message.RequestReply;
import majic.shared.message.RequestReply.Outcome;
import majic.shared.message.RequestedAction;
import majic.shared.message.UnusableMessageException;
import majic.team.Answer;
import majic.team.QueuedCommand;
import majic.text.VisibleText;
import majic.time.WaitPolicy;
import org.jspecify.annotations.Nullable;

/**
 * Carries out the requests to one robot: checks each, passes it to the robot's queue in the name of its sender, and
 * answers it. Used by the worker of the desk, for motions of the holder also by the thread of the connection; answers
 * come from the worker of the robot.
 */
final class RequestRunner {
    private final DeskContext desk;
    private final SharedRobot robot;
    private final SeenRequests seen;

    /** Were given to the queue of the robot, and nothing has been answered yet. */
    private final Queue<IncomingRequest> queued = new ConcurrentLinkedQueue<>();

    /** Does the work of a command and returns its answer. */
    private interface Work {
        RequestReply run(BotControl control);
    }

    RequestRunner(DeskContext desk, SharedRobot robot, SeenRequests seen) {
        this.desk = desk;
        this.robot = robot;
        this.seen = seen;
    }

    /** Handles a message to the topic for requests, on the worker of the desk. */
    void received(BrokerMessage message) {
        try {
            received(Request.parse(message.payload()), message, null);
        } catch (UnusableMessageException e) {
            refuse(message, String.valueOf(e.getMessage()));
        }
    }

    /**
     * Handles a motion of the holder, without blocking, on the thread of the connection.
     *
     * @return false if it is no motion of the holder; nothing was done then
     */
    boolean receivedFrom(RobotHold held, BrokerMessage message) {
        try {
            Request request = Request.parse(message.payload());
            boolean isMotion = request.action() instanceof RequestedAction.Motion && held.isOf(request.sender());
            if (isMotion) {
                WaitPolicy.without(() -> received(request, message, held));
            }
            return isMotion;
        } catch (UnusableMessageException e) {
            return false;
        }
    }

    private void received(Request request, BrokerMessage message, @Nullable RobotHold held) {
        if (message.responseTopic() != null && !desk.isAnswerable(message)) {
            robot.noticeMistake(
                    "a request of " + request.sender() + " is ignored: its response topic has to begin with "
                            + desk.topics().replies(""));
            return;
        }
        RequestReply before = seen.begin(request);
        if (before != null) {
            desk.reply(message, before);
        } else {
            begin(new IncomingRequest(desk, seen, request, message, held));
        }
    }

    private void refuse(BrokerMessage message, String why) {
        desk.reply(message, RequestReply.of(Outcome.REFUSED, why));
        robot.noticeMistake(why);
    }

    private void begin(IncomingRequest incoming) {
        try {
            checkTime(incoming.request());
            begin(incoming, incoming.action());
        } catch (BotException e) {
            incoming.answer(replyFor(e, Outcome.REFUSED));
        }
    }

    private void checkTime(Request request) {
        OptionalLong valid = request.validUntil();
        boolean only =
                request.action() instanceof RequestedAction.Get || request.action() instanceof RequestedAction.Picture;
        if (valid.isPresent()) {
            desk.clock().check(valid.getAsLong());
        } else if (!only) {
            throw new BotException(
                    "\"validUntil\" is missing; it is the \"clock\" of the robot's last state plus at most"
                            + " 1000, so that a request that comes late is not executed");
        }
    }

    private void begin(IncomingRequest incoming, RequestedAction action) {
        if (action instanceof RequestedAction.Maneuver maneuver) {
            maneuver.check(robot.bot());
            move(incoming, maneuver, maneuver::perform);
        } else if (action instanceof RequestedAction.GoTo place) {
            move(incoming, place, (control, until) -> desk.map().goTo(robot.bot(), control, place, until));
        } else if (action instanceof RequestedAction.Get get) {
            get(incoming, get);
        } else if (action instanceof RequestedAction.Set set) {
            set(incoming, set);
        } else if (action instanceof RequestedAction.Run run) {
            run(incoming, run);
        } else if (action instanceof RequestedAction.Hold) {
            robot.claim(incoming.request().sender(), false).keep();
            done(incoming);
        } else if (action instanceof RequestedAction.Free) {
            free(incoming);
        } else if (action instanceof RequestedAction.Scans) {
            scans(incoming);
        } else if (action instanceof RequestedAction.Localize) {
            localize(incoming);
        } else {
            picture(incoming);
        }
    }

    private void move(
            IncomingRequest incoming, RequestedAction.Motion motion, BiFunction<BotControl, Guard, MotionReport> work) {
        Guard until = UntilText.guard(motion.until(), desk.team(), robot.member());
        submit(incoming, true, control -> RequestReply.done(work.apply(control, until)));
    }

    private void get(IncomingRequest incoming, RequestedAction.Get get) {
        robot.bot().parameter(get.parameter());
        beside(incoming, control -> incoming.answer(RequestReply.done(control.get(get.parameter()))));
    }

    private void picture(IncomingRequest incoming) {
        MajicBot bot = robot.bot();
        if (!bot.hasCamera()) {
            throw new BotException(bot.name() + " has no camera of which pictures can be taken");
        }
        beside(incoming, control -> incoming.answer(bot.takePicture()));
    }

    private void scans(IncomingRequest incoming) {
        robot.scans().ask();
        incoming.answer(RequestReply.done(""));
    }

    private void localize(IncomingRequest incoming) {
        beside(incoming, control -> {
            desk.map().localize(robot.bot());
            incoming.answer(RequestReply.done(""));
        });
    }

    /** Runs something that moves nothing beside the queue; it leaves no line in the session. */
    private void beside(IncomingRequest incoming, Consumer<BotControl> work) {
        robot.member().runNow(new QueuedCommand(incoming.text(), false, control -> {
            try {
                work.accept(control);
            } catch (BotException e) {
                incoming.answer(replyFor(e, Outcome.FAILED));
            }
            return List.of();
        }));
        incoming.accept();
    }

    private void set(IncomingRequest incoming, RequestedAction.Set set) {
        boolean moves = robot.bot().checkSet(set.parameter(), set.values()).moves();
        submit(incoming, moves, control -> {
            control.set(set.parameter(), set.values());
            return RequestReply.done("");
        });
    }

    private void run(IncomingRequest incoming, RequestedAction.Run run) {
        robot.bot().checkRun(run.command(), run.arguments());
        boolean moves = robot.bot().commands().stream()
                .filter(command -> command.name().equalsIgnoreCase(run.command()))
                .anyMatch(BotCommand::moves);
        submit(incoming, moves, control -> RequestReply.done(control.run(run.command(), run.arguments())));
    }

    private void free(IncomingRequest incoming) {
        RobotHold hold = robot.hold();
        if (hold == null || !hold.isOf(incoming.request().sender())) {
            throw new BotException(hold == null ? "nobody holds the robot" : "the robot is held by " + hold.holder());
        }
        robot.free(hold);
        done(incoming);
    }

    /** Puts a command into the robot's queue; one that moves claims the robot first. */
    private void submit(IncomingRequest incoming, boolean moves, Work work) {
        RobotHold hold = moves ? holdFor(incoming) : null;
        QueuedCommand command = command(incoming, moves, hold, work);
        if (hold == null) {
            robot.member().submit(command, null);
        } else {
            submit(command, hold);
        }
        queued.add(incoming);
    }

    /**
     * Answers the requests that have not ended by now: another answer follows. Called by the timer of the desk, because
     * an answer that is sent at once would use the processor and the broker before the robot gets its command.
     */
    void acceptQueued() {
        for (IncomingRequest next = queued.poll(); next != null; next = queued.poll()) {
            next.accept();
        }
    }

    private RobotHold holdFor(IncomingRequest incoming) {
        RobotHold held = incoming.held();
        return held == null ? robot.claim(incoming.request().sender(), false) : held;
    }

    private void submit(QueuedCommand command, RobotHold hold) {
        hold.beat();
        hold.began();
        try {
            robot.member().submit(command, hold.owner());
        } catch (BotException e) {
            hold.completed();
            throw e;
        }
    }

    private QueuedCommand command(IncomingRequest incoming, boolean moves, @Nullable RobotHold hold, Work work) {
        AtomicReference<@Nullable RequestReply> result = new AtomicReference<>();
        return new QueuedCommand(incoming.text(), moves, control -> {
                    try {
                        RequestReply reply = work.run(control);
                        result.set(reply);
                        return List.of(incoming.text() + ": " + lineOf(reply));
                    } catch (BotException e) {
                        result.set(replyFor(e, Outcome.FAILED));
                        throw e;
                    }
                })
                .checkedBy(() -> refuseVoid(incoming.request()))
                .endingIn(answer -> ended(incoming, hold, result.get(), answer));
    }

    private void refuseVoid(Request request) {
        if (seen.isVoid(request.sender().session(), request.number())) {
            throw new MotionStopped("stopped");
        }
    }

    private void ended(
            IncomingRequest incoming, @Nullable RobotHold hold, @Nullable RequestReply result, Answer answer) {
        if (hold != null) {
            hold.completed();
        }
        robot.publisher().publishState();
        incoming.answer(result == null ? replyFor(answer) : result);
    }

    private void done(IncomingRequest incoming) {
        robot.publisher().publishState();
        incoming.answer(RequestReply.done(""));
    }

    /** The answer to a command that was not begun. */
    private static RequestReply replyFor(Answer answer) {
        boolean stopped = answer.outcome() == Answer.Outcome.STOPPED;
        return RequestReply.of(stopped ? Outcome.STOPPED : Outcome.REFUSED, answer.text());
    }

    private static RequestReply replyFor(BotException problem, Outcome otherwise) {
        Outcome outcome = problem instanceof MotionStopped
                ? Outcome.STOPPED
                : problem instanceof LinkLost ? Outcome.LOST : otherwise;
        return RequestReply.of(outcome, String.valueOf(problem.getMessage()));
    }

    private static String lineOf(RequestReply reply) {
        if (reply.report() != null) {
            return "done (" + reply.report() + ")";
        }
        return reply.text().isBlank() ? "done" : VisibleText.of(reply.text().strip());
    }
}
