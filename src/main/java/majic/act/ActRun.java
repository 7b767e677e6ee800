package majic.act;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.BiConsumer;
import java.util.function.Function;
import majic.bot.BotException;
import majic.bot.LinkLost;
import majic.bot.MajicBot;
import majic.bot.MotionStopped;
import majic.bot.Parameter;
import majic.bot.ParameterException;
import majic.driver.Permit;
import majic.nav.CurrentMap;
import majic.team.Member;
import majic.team.Owner;
import majic.time.Signal;
import majic.time.TimeSource;
import org.jspecify.annotations.Nullable;

/**
 * Runs one act on robots of a team, from claiming the robots to releasing them. A stop of one of these robots ends the
 * act for all of them: its permission to move is revoked at once, the robots are halted, and its thread is interrupted.
 * If the thread still does not end, it continues without a robot. Used once.
 */
public final class ActRun {
    private enum Phase {
        RUNNING,
        CUT_SHORT,
        OVER
    }

    /** Seconds after which an act that is still ending is reported as such, by the system's clock. */
    private static final double SOON_S = 0.5;

    /**
     * Seconds that an act may take to end, by the system's clock, because an act that does not wait stops a lab's
     * clock.
     */
    static final double GRACE_S = 2;

    private final MajicAct act;
    private final String name;
    private final List<Member> members;
    private final ActRobots robots;
    private final Signal changes;
    private final Owner owner;
    private final Permit permit;
    private final AtomicReference<Phase> phase = new AtomicReference<>(Phase.RUNNING);
    private volatile @Nullable BiConsumer<List<Member>, List<String>> plots;
    private volatile CurrentMap map = new CurrentMap((robot, news) -> {});
    private volatile @Nullable Function<String, MajicBot> team;
    private volatile boolean calledOff;
    private volatile boolean halted;
    private volatile boolean over;
    private volatile boolean leftBehind;

    /**
     * Creates a run that has not begun.
     *
     * @param act the act, not started
     * @param name the act's name in messages
     * @param members at least one robot for each of its roles, {@value Role#ME} the first
     * @param permit the permission to move all these robots, taken when the act was ordered: loading may take time, and
     *     a stop of one of the robots meanwhile stops the act
     */
    public ActRun(MajicAct act, String name, Map<String, List<Member>> members, Permit permit) {
        this(act, name, name, members, permit);
    }

    /**
     * Creates a run as the other constructor does, of an act that was given arguments.
     *
     * @param title the act's name with the arguments
     */
    public ActRun(MajicAct act, String name, String title, Map<String, List<Member>> members, Permit permit) {
        this.act = act;
        this.name = name;
        this.permit = permit;
        this.members = members.values().stream().flatMap(List::stream).toList();
        Map<String, List<MajicBot>> byRole = new LinkedHashMap<>();
        members.forEach(
                (role, its) -> byRole.put(role, its.stream().map(Member::bot).toList()));
        this.robots = new ActRobots(byRole);
        this.changes = robots.clock().signal();
        this.owner = new Owner(Owner.Kind.ACT, name, title, robots.permit(), this::end);
    }

    /**
     * Sets what shows plots for the act; without this call it can show none.
     *
     * @param window receives the act's robots and names of parameters, on the act's thread; must return at once
     */
    public void usePlots(BiConsumer<List<Member>, List<String>> window) {
        plots = window;
    }

    /**
     * Sets the map of the team; without this call the act has one of its own, which is empty at first.
     *
     * @param present of the team
     */
    public void useMap(CurrentMap present) {
        map = present;
    }

    /**
     * Sets where the act finds robots that it only looks at; without this call there are none.
     *
     * @param robots returns a robot by its number or name, or throws a {@link BotException}; called on the act's thread
     */
    public void useTeam(Function<String, MajicBot> robots) {
        team = robots;
    }

    /**
     * Runs the act and blocks until it ends, at most {@value #GRACE_S} seconds longer than it is permitted to run. In
     * every case the robots are halted and released afterwards.
     *
     * @param by the owner of the robots; null if they have none
     * @throws MotionStopped if a robot of it was stopped
     * @throws BotException if a robot cannot be claimed, or the act failed; the message gives the reason
     */
    public void run(@Nullable Owner by) {
        List<Member> sublet = new ArrayList<>();
        try {
            permit.check();
            for (Member member : members) {
                member.sublet(owner, by);
                sublet.add(member);
            }
            permit.check();
            if (!isCutShort()) {
                act.start(robots, new RunListener());
                awaitEnd();
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            end();
        } finally {
            giveBack(sublet);
        }
        report();
    }

    /** Disables every later attempt to end the act, since the robots may already have another owner. */
    private void awaitEnd() throws InterruptedException {
        changes.await(() -> over && (halted || !isCutShort()), Signal.FOR_EVER);
        if (!phase.compareAndSet(Phase.RUNNING, Phase.OVER)) {
            changes.await(() -> halted && over, Signal.FOR_EVER);
        }
    }

    private void report() {
        Throwable failure = act.failure();
        boolean lost = failure instanceof LinkLost;
        if (!lost && (isCutShort() || failure instanceof MotionStopped)) {
            reportStop();
        } else {
            FailureText.of(act).ifPresent(why -> {
                throw new BotException(why, failure == null ? act.endingFailure() : failure);
            });
        }
    }

    private void reportStop() {
        Throwable ending = act.endingFailure();
        if (ending != null && !(ending instanceof MotionStopped)) {
            notice(FailureText.ofEnding(act, ending));
        }
        if (!calledOff) {
            throw new MotionStopped("the act was ended");
        }
    }

    private boolean isCutShort() {
        return phase.get() == Phase.CUT_SHORT;
    }

    private void giveBack(Collection<Member> sublet) {
        robots.revoke();
        sublet.forEach(member -> member.endSublease(owner));
    }

    /** Ends the act; {@link #run} then returns without an exception. Returns at once. */
    public void callOff() {
        calledOff = true;
        end();
    }

    /**
     * Returns whether the act's thread was still running when its robots were released.
     *
     * @return true once {@link #run} has returned before the thread ended
     */
    public boolean isLeftBehind() {
        return leftBehind;
    }

    /**
     * Returns the owner of the robots while the act runs.
     *
     * @return the owner as registered in the robots' team
     */
    public Owner owner() {
        return owner;
    }

    /** Ends the act; returns at once. */
    private void end() {
        if (phase.compareAndSet(Phase.RUNNING, Phase.CUT_SHORT)) {
            robots.revoke();
            robots.clock().runAsync("ending " + name, this::halt);
        }
    }

    private void halt() {
        try {
            act.end();
        } finally {
            halted = true;
            changes.raise();
            TimeSource.system().runAsync("awaiting the end of " + name, this::awaitEnding);
        }
    }

    private void awaitEnding() {
        try {
            if (isAliveAfter(SOON_S)) {
                notice("is still ending; its robots are stopped and no longer obey it");
                leftBehind = isAliveAfter(GRACE_S - SOON_S);
            }
            if (leftBehind) {
                notice("does not end; it is left behind without a robot");
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
        finish();
    }

    private boolean isAliveAfter(double seconds) throws InterruptedException {
        act.join((long) (seconds * 1000));
        return act.isAlive();
    }

    private void finish() {
        over = true;
        changes.raise();
    }

    private void notice(String text) {
        members.get(0).report(owner, text);
    }

    /** Receives the act's notes and its end. */
    private final class RunListener implements ActListener {
        @Override
        public void said(String words) {
            if (!isCutShort()) {
                notice(words);
            }
        }

        @Override
        public void plot(List<String> parameters) {
            BiConsumer<List<Member>, List<String>> window = plots;
            if (window == null) {
                ActListener.super.plot(parameters);
            } else if (!isCutShort()) {
                window.accept(members, parameters.stream().map(this::plotted).toList());
            }
        }

        /** Returns the name of a parameter as the robots spell it. */
        private String plotted(String name) {
            return members.stream()
                    .flatMap(member -> member.bot().parameters().stream())
                    .filter(known -> known.name().equalsIgnoreCase(name)
                            && known.readable()
                            && known.kind() != Parameter.Kind.TEXT
                            && known.kind() != Parameter.Kind.CHOICE)
                    .map(Parameter::name)
                    .findFirst()
                    .orElseThrow(() -> new ParameterException(
                            name, name + ": no robot of the act has a number or switch of this name that can be read"));
        }

        @Override
        public CurrentMap map() {
            return map;
        }

        @Override
        public MajicBot teamMate(String name) {
            Function<String, MajicBot> robots = team;
            return robots == null ? ActListener.super.teamMate(name) : robots.apply(name);
        }

        @Override
        public void ended() {
            finish();
        }
    }
}
