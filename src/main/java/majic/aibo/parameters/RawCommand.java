package majic.aibo.parameters;

import java.util.List;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import majic.aibo.body.DogState;
import majic.aibo.session.AiboSession;
import majic.aibo.session.RunningMotion;
import majic.aibo.urbi.RawText;
import majic.aibo.urbi.UrbiMessage;
import majic.aibo.urbi.UrbiText;
import majic.bot.MotionFailed;
import majic.bot.Parameter;
import majic.driver.DriverCommand;
import majic.driver.Motion;

/**
 * Passes a typed command to the dog unchanged, for functions without a parameter. It may move the dog, so only its
 * owner may send it. It runs as a block with a tag, so that its end is reported and a stop ends everything it does.
 */
public final class RawCommand {
    private static final double LONGEST_S = 30;
    private static final Set<String> NO_ANSWERS = Set.of("start", "ident", "power");

    private final AiboAccess access;
    private final DogState dog;

    public RawCommand(AiboAccess access, DogState dog) {
        this.dog = dog;
        this.access = access;
    }

    public DriverCommand command() {
        return new DriverCommand(
                        "urbi",
                        List.of(Parameter.text("text", "as the dog's manual has it")),
                        true,
                        "sends a command to the dog unchanged and shows what it answers within 30 s",
                        (arguments, motion) ->
                                run(RawText.checked(arguments.get(0).toString()), motion))
                .asRaw();
    }

    private String run(String text, Motion motion) {
        AiboSession open = access.open();
        open.executor().awaitFree(motion);
        List<UrbiMessage> answers = new CopyOnWriteArrayList<>();
        RunningMotion running = open.executor()
                .command(open.connections().motion(), "{ " + text + " }")
                .unknown();
        motion.send(open.guard()::renew);
        Runnable stopListening = open.listen(answers::add);
        try {
            open.executor().perform(motion, running, LONGEST_S);
        } finally {
            stopListening.run();
        }
        dog.setStanding(false);
        return answerText(answers);
    }

    private static String answerText(List<UrbiMessage> answers) {
        List<UrbiMessage> relevant = answers.stream()
                .filter(answer -> !NO_ANSWERS.contains(answer.tag()))
                .toList();
        String text = String.join(
                "; ",
                relevant.stream().map(answer -> UrbiText.of(answer.body())).toList());
        if (relevant.stream().anyMatch(answer -> answer.body() instanceof UrbiMessage.Failure)) {
            throw new MotionFailed("the dog says: " + text);
        }
        return text.isEmpty() ? "done, without an answer" : text;
    }
}
