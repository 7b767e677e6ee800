import java.util.ArrayList;
import java.util.List;
import majic.act.Argument;
import majic.act.MajicAct;
import majic.act.Role;
import majic.bot.BotControl;
import majic.bot.Unit;
import majic.bot.Value;

/**
 * Different robots race side by side, over a metre unless another length is given. A robot stops at the finish or at an
 * obstacle on the way.
 */
public final class MajicRace extends MajicAct {
    private static final long serialVersionUID = 1;
    private static final double STEP_S = 0.1;
    private static final int MOST_SLIPS = 3;

    @Argument(value = "how long the race is", unit = Unit.MM, from = 100, to = 20_000)
    private double course = 1000;

    @Override
    public List<Role> roles() {
        return List.of(racing(Role.ME), racing("rival").orMore());
    }

    private static Role racing(String name) {
        return Role.any(name).with("distanceFront", "near", "cruise");
    }

    @Override
    protected void behave() {
        List<Racer> racing = new ArrayList<>();
        racing.add(new Racer(bot));
        robots("rival").forEach(rival -> racing.add(new Racer(rival)));
        while (racing.stream().anyMatch(Racer::isBlind)) {
            pause(STEP_S);
        }
        say("go");
        for (int place = 1; !racing.isEmpty(); pause(STEP_S)) {
            for (Racer racer : List.copyOf(racing)) {
                if (racer.goneMm() >= course) {
                    say("number " + place + " is " + racer.robot.name());
                    place++;
                    racing.remove(racer);
                } else if (racer.staysBlocked()) {
                    say(racer.robot.name() + " is out: something is in its way");
                    racing.remove(racer);
                }
                racer.robot.drive(racing.contains(racer) && !racer.isBlocked() ? racer.number("cruise") : 0, 0);
            }
        }
    }

    /** Holds a robot in the race and where it started. */
    private static final class Racer {
        private final BotControl robot;
        private final double startX;
        private final double startY;
        private int blockedSteps;

        Racer(BotControl robot) {
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

        /** Returns whether an obstacle stays in the way. A single reading, which may be wrong, only stops the robot. */
        boolean staysBlocked() {
            blockedSteps = isBlocked() ? blockedSteps + 1 : 0;
            return blockedSteps > MOST_SLIPS;
        }

        double number(String parameter) {
            return robot.get(parameter).number();
        }
    }
}
