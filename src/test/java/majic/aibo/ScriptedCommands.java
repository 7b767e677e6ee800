package majic.aibo;

import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** What a scripted dog makes of the commands of one connection. */
final class ScriptedCommands {
    private static final Pattern POLL = Pattern.compile("(\\w+): every\\((\\d+)\\) \\{ (.*) \\}");
    private static final Pattern READING = Pattern.compile("(\\w+)(:| <<) ([\\w.]+(?:\\(\\))?)");
    private static final Pattern ENDING = Pattern.compile("(\\w+)(\\+begin)?\\+end: (.*)", Pattern.DOTALL);
    private static final Pattern GAIT = Pattern.compile("robot\\.(walk|turn)\\((-?\\d+)\\)");
    private static final Pattern RENEWAL = Pattern.compile("majic\\.\\w+ = (\\d+)");
    private static final Pattern JOINT = Pattern.compile("(\\w+)\\.val = (-?[\\d.]+)(?: time:(\\d+))?");
    private static final int GUARD_PATIENCE_MS = 1500;

    private final ScriptedDog dog;
    private final ScriptedLine line;
    private final ScriptedErrands errands;

    ScriptedCommands(ScriptedDog dog, ScriptedLine line) {
        this.dog = dog;
        this.line = line;
        this.errands = dog.errands();
    }

    void execute(String command) {
        Matcher poll = POLL.matcher(command);
        Matcher ending = ENDING.matcher(command);
        Matcher renewal = RENEWAL.matcher(command);
        if (command.equals("quit")) {
            line.close();
        } else if (renewal.matches()) {
            dog.aliveMs = Double.parseDouble(renewal.group(1));
        } else if (command.startsWith("stop ")) {
            errands.stop(command.substring(5));
        } else if (poll.matches() && command.contains("time()")) {
            guard();
        } else if (poll.matches()) {
            errands.repeat(poll.group(1), Long.parseLong(poll.group(2)), () -> tell(poll.group(3)));
        } else if (ending.matches()) {
            perform(ending.group(1), ending.group(2) != null, ending.group(3));
        } else if (command.endsWith(": ping")) {
            line.say(dog.speaks15 ? "" : command.substring(0, command.indexOf(':')), "*** pong time=" + dog.nowMs());
        } else {
            tell(command);
        }
    }

    private void guard() {
        if (dog.refusesGuards) {
            line.say("error", "!!! 21.9: syntax error, unexpected every");
        } else {
            errands.repeat("guard", 200, this::lookAtGuard);
        }
    }

    private void lookAtGuard() {
        if (dog.nowMs() - dog.aliveMs > GUARD_PATIENCE_MS && dog.isWalking()) {
            dog.guardEnded.incrementAndGet();
            errands.stop("walk");
            errands.stop("turn");
        }
    }

    private void tell(String readings) {
        Matcher reading = READING.matcher(readings);
        while (reading.find() && dog.answersPolls) {
            boolean channel = reading.group(2).equals(" <<");
            String expression = reading.group(3);
            if (!expression.equals(dog.silentAbout)) {
                String tag = channel == dog.speaks15 ? reading.group(1) : "";
                line.say(tag, channel && !dog.speaks15 ? "!!! syntax error" : dog.value(expression));
            }
        }
    }

    private void perform(String tag, boolean begin, String command) {
        if (command.contains(dog.knowsNo)) {
            line.say(tag, "!!! Error with function eval: " + dog.knowsNo + " [no param]");
            return;
        }
        if (begin && dog.reportsBegin) {
            line.say(tag, "*** begin");
        }
        Matcher gait = GAIT.matcher(command);
        String name = gait.find() ? gait.group(1) : tag;
        errands.begin(name, lastsMs(command), () -> end(tag, command), () -> line.say(tag, "*** end"));
    }

    private long lastsMs(String command) {
        Matcher gait = GAIT.matcher(command);
        Matcher joint = JOINT.matcher(command);
        if (gait.find()) {
            return Math.abs(Long.parseLong(gait.group(2)));
        }
        return joint.find() && joint.group(3) != null ? Long.parseLong(joint.group(3)) : dog.lastingMs;
    }

    private void end(String tag, String command) {
        Matcher joint = JOINT.matcher(command);
        if (joint.find()) {
            dog.set(joint.group(1) + ".val", joint.group(2) + ".000000");
        }
        if (command.contains("stand")) {
            dog.set("robot.MyguessPosition()", "\"stand\"");
            dog.set("legLF1.load", "1.000000");
        }
        if (command.contains("robot.lay") && !dog.staysUp) {
            dog.set("robot.MyguessPosition()", '"' + dog.guessOnceDown + '"');
        }
        if (command.contains("motors off")) {
            dog.set("legLF1.load", "0.000000");
        }
        sayEnd(tag, command);
    }

    /** A command for a group ends for each of its members, and seldom under its own tag (URBI sheet 21). */
    private void sayEnd(String tag, String command) {
        switch (command) {
            case "motors off" -> sayEnds("__system__", 19);
            case "ledF = 1" -> {
                sayEnds(tag, 14);
                sayEnds("__system__", 1);
            }
            default -> sayEnds(tag, 1);
        }
    }

    private void sayEnds(String tag, int times) {
        for (int i = 0; i < times; i++) {
            line.say(tag, "*** end");
        }
    }
}
