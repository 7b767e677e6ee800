package majic.script;

import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import majic.bot.BotControl;
import majic.bot.BotException;
import majic.bot.Guard;
import majic.bot.MajicBot;
import majic.bot.MotionReport;
import majic.bot.Pose;
import majic.driver.Permit;
import majic.nav.CurrentMap;
import majic.nav.Destination;
import majic.nav.GiveWay;
import majic.team.Answer;
import majic.team.Member;
import majic.team.QueuedCommand;
import majic.team.Team;

/**
 * Has idle robots of a team make room, by a {@code goto} in their queues as if it was typed. Asks no robot that has
 * something of its own to do. Thread-safe.
 */
final class TeamGiveWay implements GiveWay {
    /** A robot that has moved farther since it was asked is left where it is. */
    private static final double SAME_PLACE_MM = 50;

    private final Team team;
    private final CurrentMap map;
    private final Predicate<Member> isOfAnotherDesk;

    /**
     * Asks the robots of a team.
     *
     * @param isOfAnotherDesk whether a robot is commanded through another desk, which alone knows what it has to do
     */
    TeamGiveWay(Team team, CurrentMap map, Predicate<Member> isOfAnotherDesk) {
        this.team = team;
        this.map = map;
        this.isOfAnotherDesk = isOfAnotherDesk;
    }

    private Optional<Member> member(MajicBot robot) {
        return team.members().stream().filter(member -> member.bot() == robot).findFirst();
    }

    @Override
    public Requests begin(MajicBot waiting) {
        Optional<Member> asker = member(waiting);
        if (asker.isEmpty()) {
            return NEVER.begin(waiting);
        }
        Permit permit = asker.get().currentPermit();
        return (standing, aside, failed) -> member(standing)
                .filter(this::isFree)
                .map(member -> new Request(asker.get(), member, permit.and(member.currentPermit()), failed))
                .flatMap(request -> aside.get().map(request::submit))
                .orElse(false);
    }

    private boolean isFree(Member member) {
        return member.owner() == null
                && member.isIdle()
                && !member.isStopLatched()
                && member.bot().isConnected()
                && !isOfAnotherDesk.test(member);
    }

    /** One robot asks another one, under a permit that a stop of either revokes. */
    private final class Request {
        private final Member asker;
        private final Member asked;
        private final Permit permit;
        private final Runnable failed;
        private final Pose stood;

        Request(Member asker, Member asked, Permit permit, Runnable failed) {
            this.asker = asker;
            this.asked = asked;
            this.permit = permit;
            this.failed = failed;
            this.stood = asked.bot().state().pose();
        }

        boolean submit(Destination aside) {
            String text = "goto " + aside + " (makes room for " + asker.number() + ")";
            QueuedCommand command = new QueuedCommand(
                            text, true, robot -> List.of(text + ": done (" + drive(robot, aside) + ")"))
                    .checkedBy(this::check)
                    .endingIn(this::ended);
            try {
                asked.submit(command, null);
                return true;
            } catch (BotException e) {
                return false;
            }
        }

        private MotionReport drive(BotControl robot, Destination aside) {
            asked.notice("makes room for " + asker.bot().name());
            return map.navigator().goTo(asked.bot(), robot, aside, Guard.NEVER);
        }

        private void check() {
            permit.check();
            if (asked.bot().state().pose().distanceMm(stood) > SAME_PLACE_MM) {
                throw new BotException("it has moved since it was asked");
            }
        }

        private void ended(Answer answer) {
            if (answer.outcome() != Answer.Outcome.DONE) {
                failed.run();
            }
        }
    }
}
