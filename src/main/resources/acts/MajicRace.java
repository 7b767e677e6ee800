import java.util.ArrayList;
import java.util.List;
import majic.act.MajicAct;
import majic.act.Role;
import majic.bot.BotControl;
import majic.bot.Value;

/** Three different robots race side by side over a metre. A robot stops at the finish or at an obstacle on the way. */
public final class MajicRace extends MajicAct {
    private static final long serialVersionUID = 1;
    private static final double COURSE_MM = 1000;
    private static final double STEP_S = 0.1;
    private static final int MOST_SLIPS = 3;

    @Override
    public List<Role> roles() {
        return List.of(
                Role.any(Role.ME).types("aibo"),
                Role.any("pioneer").types("pioneer"),
                Role.any("hemisson").types("hemisson"));
    }

    @Override
    protected void behave() {
        List<Racer> racing = new ArrayList<>();
        roles().forEach(role -> racing.add(new Racer(role.types().get(0), robot(role.name()))));
        while (racing.stream().anyMatch(Racer::isBlind)) {
            pause(STEP_S);
        }
        say("go");
        for (int place = 1; !racing.isEmpty(); pause(STEP_S)) {
            for (Racer racer : List.copyOf(racing)) {
                if (racer.goneMm() >= COURSE_MM) {
                    say("number " + place + " is the " + racer.name);
                    place++;
                    racing.remove(racer);
                } else if (racer.staysBlocked()) {
                    say("the " + racer.name + " is out: something is in its way");
                    racing.remove(racer);
                }
                racer.robot.drive(racing.contains(racer) && !racer.isBlocked() ? racer.number("cruise") : 0, 0);
            }
        }
    }

    /** Holds a robot in the race and where it started. */
    private static final class Racer {
        private final String name;
        private final BotControl robot;
        private final double startX;
        private final double startY;
        private int blockedSteps;

        Racer(String name, BotControl robot) {
            this.name = name;
            this.robot = robot;
            this.startX = number("x");
            this.startY = number("y");
        }

        double goneMm() {
            return Math.hypot(number("x") - startX, number("y") - startY);
        }

        boolean isBlind() {
            return robot.get("distanceFront") instanceof Value.Unknown;
        }

        boolean isBlocked() {
            return number("distanceFront") < number("near");
        }

        /**
         * Returns whether an obstacle stays in the way. A single reading, which may be wrong, only stops the robot.
         */
        boolean staysBlocked() {
            blockedSteps = isBlocked() ? blockedSteps + 1 : 0;
            return blockedSteps > MOST_SLIPS;
        }

        double number(String parameter) {
            return robot.get(parameter).number();
        }
    }
}
