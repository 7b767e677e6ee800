package majic.aibo.session;

import java.util.Set;
import java.util.function.Consumer;
import majic.aibo.body.DogState;
import majic.aibo.body.Posture;
import majic.aibo.urbi.UrbiCommands;
import majic.aibo.urbi.UrbiConnection;
import majic.aibo.urbi.UrbiRefusal;
import majic.aibo.urbi.UrbiValue;
import majic.bot.MotionFailed;
import majic.driver.Motion;
import org.jspecify.annotations.Nullable;

/** Gets the dog onto its feet before it walks, with its motors on, and into other postures. */
public final class PostureControl {
    private static final Set<String> DOWN = Set.of("sit", "lay");
    private static final Set<String> FALLEN = Set.of("side", "back");
    private static final Set<String> UP = Set.of("stand", "sit");
    private static final Set<String> LOW = Set.of("lay", "side", "back");

    /** A slow engine answers two seconds late; so does the end of everything here. */
    private static final double GUESS_S = 4;

    private static final double POWER_S = 5;
    /** Four seconds for the longest (URBI sheet 15). */
    private static final double POSTURE_S = 8;

    private final MotionExecutor executor;
    private final UrbiConnection connection;
    private final UrbiQuestions questions;
    private final DogState dog;
    private final Consumer<String> notice;
    private volatile boolean layingFailed;

    /** Sends everything on the connection for motion. */
    PostureControl(
            MotionExecutor executor,
            UrbiConnection connection,
            UrbiQuestions questions,
            DogState dog,
            Consumer<String> notice) {
        this.executor = executor;
        this.connection = connection;
        this.questions = questions;
        this.dog = dog;
        this.notice = notice;
    }

    /** Makes sure that it stands with stiff legs. Takes up to five seconds when it does not. */
    void stand(Motion motion) {
        executor.awaitFree(motion);
        String posture = posture();
        refuseFallen(posture);
        boolean powered = dog.senses().motorsOn().orElse(false);
        boolean stands = posture.equals("stand") || (dog.isStanding() && !DOWN.contains(posture));
        if (!powered || !stands) {
            notice.accept(rising(powered));
            RunningMotion rise = rise(powered);
            executor.perform(motion, rise, POSTURE_S);
            dog.senses().assumeMotors(true, rise.endedMs());
        }
        dog.setStanding(true);
    }

    /** A dog that lies on its back or side does not walk, and getting up from there is not among its tricks. */
    void refuseFallen(@Nullable String posture) {
        boolean known = posture != null && FALLEN.contains(posture);
        if (known || dog.senses().isOnItsBack()) {
            throw new MotionFailed("the dog lies on its " + (known ? posture : "back") + "; put it on its feet");
        }
    }

    /** What gets it up, to be started by a drive. Null if it stands already, as far as is known. */
    @Nullable
    RunningMotion rise() {
        boolean powered = dog.senses().motorsOn().orElse(false);
        if (powered && (dog.isStanding() || "stand".equals(dog.senses().posture()))) {
            return null;
        }
        notice.accept(rising(powered));
        return rise(powered);
    }

    private static String rising(boolean powered) {
        return powered ? "the dog stands up first" : "switches the dog's motors on and stands it up first";
    }

    private RunningMotion rise(boolean powered) {
        return powered
                ? executor.command(connection, Posture.STAND.call())
                : executor.command(
                        connection, tag -> "{ motors on; wait(1000); " + tag + ": " + Posture.STAND.call() + " }");
    }

    /** Switches the motors on where they are off; what moves a joint needs no more. */
    public void power(Motion motion) {
        executor.awaitFree(motion);
        if (!dog.senses().motorsOn().orElse(false)) {
            notice.accept("switches the dog's motors on");
            RunningMotion switching = executor.command(connection, "{ motors on; wait(1000) }");
            executor.perform(motion, switching, POWER_S);
            dog.senses().assumeMotors(true, switching.endedMs());
        }
    }

    /**
     * Lays the dog down where it is up, then lets its joints go loose. A dog that did not lie down keeps its motors on,
     * for it would fall; a second request switches them off all the same.
     */
    public void loosen(Motion motion) {
        executor.awaitFree(motion);
        dog.setStanding(false);
        boolean mayFall = dog.senses().motorsOn().orElse(true) && !LOW.contains(posture());
        if (mayFall && !layingFailed) {
            layDown(motion);
        }
        layingFailed = false;
        RunningMotion switching = executor.command(connection, UrbiCommands.toGroup("motors off"));
        executor.perform(motion, switching, POWER_S);
        dog.senses().assumeMotors(false, switching.endedMs());
    }

    private void layDown(Motion motion) {
        try {
            executor.perform(motion, executor.command(connection, Posture.LAY.call()), POSTURE_S);
            String posture = posture();
            if (UP.contains(posture)) {
                throw new MotionFailed("the dog was to lie down, but tells that it is in posture " + posture);
            }
        } catch (MotionFailed e) {
            layingFailed = true;
            throw new MotionFailed(e.getMessage()
                    + "; its motors stay on, for it would fall; ask once more and they go off all the same");
        }
    }

    /** Brings it into a posture by one of the stick's functions. */
    public void take(Posture posture, Motion motion) {
        power(motion);
        dog.setStanding(false);
        layingFailed = false;
        executor.perform(motion, executor.command(connection, posture.call()), POSTURE_S);
        dog.setStanding(posture == Posture.STAND);
    }

    /** Returns the posture that the dog reports; "unknown" also if it reports none. */
    public String posture() {
        try {
            return questions.ask(connection, "robot.MyguessPosition()", GUESS_S) instanceof UrbiValue.Str guess
                    ? guess.text()
                    : "unknown";
        } catch (UrbiRefusal e) {
            return "unknown";
        }
    }
}
