package majic.aibo;

import java.util.Set;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import majic.bot.BotException;
import majic.bot.Motion;
import majic.bot.MotionFailed;
import org.jspecify.annotations.Nullable;

/** Gets the dog onto its feet before it walks, with its motors on, and into other postures. */
final class Feet {
    private static final Set<String> DOWN = Set.of("sit", "lay");
    private static final Set<String> FALLEN = Set.of("side", "back");
    private static final double GUESS_S = 2;
    private static final double POWER_S = 3;
    private static final double STAND_S = 8;

    private final AiboSession session;
    private final Dog dog;
    private final Consumer<String> notice;

    Feet(AiboSession session, Dog dog, Consumer<String> notice) {
        this.session = session;
        this.dog = dog;
        this.notice = notice;
    }

    /** Makes sure that it stands with stiff legs. Takes up to five seconds when it does not. */
    void stand(Motion motion) {
        session.awaitFree(motion);
        String posture = posture();
        refuseFallen(posture);
        boolean powered = dog.senses().motorsOn().orElse(false);
        boolean stands = posture.equals("stand") || (dog.isAfoot() && !DOWN.contains(posture));
        if (!powered || !stands) {
            notice.accept(rising(powered));
            perform(motion, session.runner().command(session.links().motion(), risingCommands(powered)), STAND_S);
            dog.senses().assumeMotors(true);
        }
        dog.setAfoot(true);
    }

    /** A dog that lies on its back or side does not walk, and getting up from there is not among its tricks. */
    void refuseFallen(@Nullable String posture) {
        boolean known = posture != null && FALLEN.contains(posture);
        if (known || dog.senses().isOnItsBack()) {
            throw new MotionFailed("the dog lies on its " + (known ? posture : "back") + "; put it on its feet");
        }
    }

    /** Begins to get up without waiting, for a drive. Null if it stands already, as far as is known. */
    @Nullable
    Running rise() {
        boolean powered = dog.senses().motorsOn().orElse(false);
        if (powered && (dog.isAfoot() || "stand".equals(dog.senses().posture()))) {
            return null;
        }
        notice.accept(rising(powered));
        return session.runner().command(session.links().motion(), risingCommands(powered));
    }

    private static String rising(boolean powered) {
        return powered ? "the dog stands up first" : "switches the dog's motors on and stands it up first";
    }

    private static String risingCommands(boolean powered) {
        return powered ? "robot.stand()" : "{ motors on; wait(1000); robot.stand() }";
    }

    /** Switches the motors on where they are off; what moves a joint needs no more. */
    void power(Motion motion) {
        session.awaitFree(motion);
        if (!dog.senses().motorsOn().orElse(false)) {
            notice.accept("switches the dog's motors on");
            perform(motion, session.runner().command(session.links().motion(), "{ motors on; wait(1000) }"), POWER_S);
            dog.senses().assumeMotors(true);
        }
    }

    /** Lays the dog down where it is up, then lets its joints go loose. */
    void loosen(Motion motion) {
        session.awaitFree(motion);
        boolean powered = dog.senses().motorsOn().orElse(true);
        boolean down = posture().equals("lay");
        dog.setAfoot(false);
        String lay = powered && !down ? "robot.lay(); " : "";
        perform(motion, session.runner().command(session.links().motion(), "{ " + lay + "motors off }"), STAND_S);
        dog.senses().assumeMotors(false);
    }

    /** Brings it into a posture by one of the stick's functions. */
    void take(String function, double seconds, Motion motion) {
        power(motion);
        dog.setAfoot(false);
        perform(motion, session.runner().command(session.links().motion(), "robot." + function + "()"), seconds);
        dog.setAfoot(function.equals("stand"));
    }

    /** What the dog takes its posture for; "unknown" also if it cannot tell. */
    String posture() {
        try {
            return session.ask(session.links().motion(), "robot.MyguessPosition()", GUESS_S)
                            instanceof UrbiValue.Str guess
                    ? guess.text()
                    : "unknown";
        } catch (UrbiRefusal e) {
            return "unknown";
        }
    }

    /** Does one thing to its end, whatever the guard says: half risen is no way to stay. */
    void perform(Motion motion, Running running, double seconds) {
        motion.send(() -> session.runner().start(running, () -> true));
        BooleanSupplier over = () -> running.isOver() || !stillGoes(motion);
        boolean ended = session.watch().await(over, seconds);
        motion.check();
        if (!ended) {
            running.requestStop();
            throw new MotionFailed("the dog did not end it within " + (int) seconds + " s");
        }
        String failure = running.failure();
        if (failure != null) {
            throw new MotionFailed("the dog refuses: " + failure);
        }
    }

    private static boolean stillGoes(Motion motion) {
        try {
            motion.check();
            return true;
        } catch (BotException e) {
            return false;
        }
    }
}
