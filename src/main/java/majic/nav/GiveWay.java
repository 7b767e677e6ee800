package majic.nav;

import java.util.Optional;
import java.util.function.Supplier;
import majic.bot.MajicBot;

/** Asks robots that stand in the way of others to make room. */
@FunctionalInterface
public interface GiveWay {
    /** Asks no robot. */
    GiveWay NEVER = waiting -> (standing, aside, failed) -> false;

    /**
     * Prepares for the motion of one robot.
     *
     * @param waiting the robot that may have to ask others; nothing moves for it any more once it was stopped after
     *     this call
     * @return asks on behalf of that robot
     */
    Requests begin(MajicBot waiting);

    /** The requests on behalf of one robot. */
    @FunctionalInterface
    interface Requests {
        /**
         * Has a robot drive aside, under the conditions of any command to it. Must return soon; the robot drives later.
         *
         * @param standing stationary, placed, with its parameter {@code giveWay} on
         * @param aside finds where it leaves room, in the frame of its poses; is called once, only if the robot can be
         *     asked, and may take as long as a way is planned
         * @param failed called on any thread if it was asked but has not driven there, for whatever reason
         * @return whether it was asked; false if it has something else to do, must not move, or there is no place
         */
        boolean ask(MajicBot standing, Supplier<Optional<Destination>> aside, Runnable failed);
    }
}
