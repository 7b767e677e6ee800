package majic.script;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Supplier;
import majic.act.ActFile;
import majic.act.ActRun;
import majic.act.Acts;
import majic.act.MajicAct;
import majic.act.Role;
import majic.bot.BotException;
import majic.bot.MotionStopped;
import majic.bot.Permit;
import majic.script.syntax.Command;
import majic.script.syntax.Literal;
import majic.script.syntax.Robots;
import majic.script.syntax.ScriptException;
import majic.script.syntax.Wording;
import majic.team.Member;
import majic.team.Order;
import majic.time.Signal;

/** Runs behaviours on the robots of a session: finds them, sees that robots and roles fit, ends them. Thread-safe. */
final class Behaviours {
    private static final int SHORTEST_HASH = 8;

    private final Session session;
    private final Acts acts;
    private final List<ActRun> running = new CopyOnWriteArrayList<>();

    /** By robot, the leave of all that was ordered since its last {@code act off} and may still wait for its turn. */
    private final Map<Member, Permit> ordered = new ConcurrentHashMap<>();

    Behaviours(Session session, Acts acts) {
        this.session = session;
        this.acts = acts;
    }

    /**
     * A behaviour that was found.
     *
     * @param name what messages call it
     * @param roles the robots it asks for
     * @param script what it says, if it is a script
     * @param fresh makes one to run
     */
    private record Found(String name, List<Role> roles, Optional<ScriptAct> script, Supplier<MajicAct> fresh) {
        /** Of one whose code is MAJIC's own. */
        Found(String name, MajicAct act) {
            this(
                    name,
                    act.roles(),
                    Optional.of(act).filter(ScriptAct.class::isInstance).map(ScriptAct.class::cast),
                    () -> act);
        }
    }

    Acts acts() {
        return acts;
    }

    /**
     * Looks whether a behaviour can be given to a robot.
     *
     * @throws ScriptException if not; it says what would be right
     */
    void check(Command.Act act, Member me, Selection selection) {
        ScriptException.placed(act.name().at(), () -> {
            Found found = find(act.name());
            Map<String, List<Member>> cast = cast(act, found, me, others(act, selection));
            found.script().ifPresent(script -> script.check(session, cast));
        });
    }

    /** Runs a behaviour in the robot's turn; the order lasts as long as it does. */
    Order order(Command.Act act, Member me, Execution execution) {
        String text = Wording.of(act);
        List<Member> others = others(act, execution.selection());
        Permit leave = leave(me, others);
        return new Order(text, true, robot -> {
            Found found = find(act.name());
            Map<String, List<Member>> cast = cast(act, found, me, others);
            sayIfOwn(SessionCheck.text(act.name()), me);
            long began = me.time().nanos();
            ActRun run = run(found, cast, leave, execution);
            String how = run.isLeftBehind() ? "left behind without a robot, it does not end" : "done";
            return List.of(text
                    + String.format(Locale.ROOT, ": %s (%.1f s)", how, me.time().secondsSince(began)));
        });
    }

    private void sayIfOwn(String name, Member me) {
        if (acts.replacesShipped(name)) {
            session.say(
                    Line.Kind.NOTICE,
                    me.number() + ": " + name + " from " + acts.folder()
                            + ", in place of the one that comes with MAJIC");
        }
    }

    private static Map<String, List<Member>> cast(Command.Act act, Found found, Member me, List<Member> others) {
        return Casting.cast(SessionCheck.text(act.name()), found.roles(), me, others);
    }

    private Permit leave(Member me, List<Member> others) {
        Permit all = leave(me);
        for (Member other : others) {
            all = all.and(leave(other));
        }
        return all;
    }

    private Permit leave(Member member) {
        return member.leave().and(ordered.computeIfAbsent(member, its -> new Permit()));
    }

    private ActRun run(Found found, Map<String, List<Member>> cast, Permit leave, Execution execution) {
        MajicAct act = found.fresh().get();
        ActRun run = new ActRun(act, found.name(), cast, leave);
        if (act instanceof ScriptAct script) {
            script.enter(session, run.owner(), cast, execution.asker());
        }
        running.add(run);
        try {
            run.run(execution.owner());
        } finally {
            running.remove(run);
            session.team().changes().raise();
        }
        return run;
    }

    /**
     * Ends the behaviour that a robot runs, or plays a part in. One that was ordered and still waits for its turn is
     * stopped when that comes.
     *
     * @return answers once the robot is free, which takes as long as its stop and at most {@code ActRun}'s grace; answers
     *     at once if no behaviour runs on it
     */
    Order callOff(Member member) {
        Permit before = ordered.remove(member);
        if (before != null) {
            before.revoke(() -> new MotionStopped("called off"));
        }
        List<ActRun> its =
                running.stream().filter(run -> run.owner() == member.owner()).toList();
        its.forEach(ActRun::callOff);
        return new Order("act off", false, robot -> {
            awaitEnd(its);
            return List.of("act off: " + (its.isEmpty() ? "no behaviour runs on it" : "done"));
        });
    }

    private void awaitEnd(List<ActRun> ending) {
        try {
            session.team().changes().await(() -> ending.stream().noneMatch(running::contains), Signal.FOR_EVER);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    /** One line for each behaviour that needs no path. */
    List<String> list() {
        List<String> names = acts.names();
        return names.isEmpty()
                ? List.of("acts: none; \"1 act FILE\" takes any file that ends in " + Acts.ENDING + " or "
                        + ScriptAct.ENDING)
                : names.stream().map(this::listed).toList();
    }

    private String listed(String name) {
        try {
            ActOffer offer = session.offers().find(name);
            String roles =
                    String.join(", ", offer.roles().stream().map(Role::toString).toList());
            String own = acts.replacesShipped(name) ? " (your own, in place of the one that comes with MAJIC)" : "";
            return "acts: " + name + " (" + roles + "): " + offer.details().description() + own;
        } catch (BotException e) {
            return "acts: " + name + ": " + e.getMessage();
        }
    }

    /** What a behaviour brings. With the beginning of its hash, the person agrees to that very file. */
    List<String> trust(String name, String hash) {
        ActFile file = acts.find(name);
        if (acts.trust().isTrusted(file)) {
            return List.of("trust " + name + ": agreed to already");
        }
        List<String> told = new ArrayList<>();
        if (hash.isEmpty()) {
            file.describe().forEach(line -> told.add("trust " + name + ": " + line));
            // In quotes, as many a hash begins like a number.
            told.add("trust " + name + ": its code can do all that you can; if you agree: trust "
                    + SessionRecord.quoted(name) + " \"" + file.sha256().substring(0, SHORTEST_HASH) + '"');
        } else if (hash.length() < SHORTEST_HASH || !file.sha256().startsWith(hash.toLowerCase(Locale.ROOT))) {
            throw new BotException("trust " + name + ": the hash of this file is " + file.sha256());
        } else {
            acts.trust().agree(file);
            told.add("trust " + name + ": done");
        }
        return told;
    }

    /** Takes the consent to a file back. */
    String trustOff(String nameOrHash) {
        boolean agreed = acts.trust().takeBack(hashOf(nameOrHash));
        return "trust off " + nameOrHash + ": " + (agreed ? "done" : "nobody had agreed to that file");
    }

    /** The hash that was given, or that of the file. */
    String hashOf(String nameOrHash) {
        return nameOrHash.matches("[0-9a-fA-F]{64}")
                ? nameOrHash.toLowerCase(Locale.ROOT)
                : acts.find(nameOrHash).sha256();
    }

    /** The further robots a command names. */
    static List<Member> others(Command.Act act, Selection selection) {
        Robots others = act.others();
        return others == null ? List.of() : selection.members(others);
    }

    private Found find(Literal name) {
        String text = SessionCheck.text(name);
        return scriptAt(text).map(Behaviours::script).orElseGet(() -> file(text));
    }

    /** The file of a script that goes by a name or path; empty if an act does. */
    Optional<Path> scriptAt(String name) {
        return acts.locate(name).filter(path -> Acts.isScript(path.toString()));
    }

    private static Found script(Path path) {
        ScriptAct act = ScriptAct.read(path);
        String name = act.title().substring(0, act.title().length() - ScriptAct.ENDING.length());
        return new Found(name, act);
    }

    /**
     * The robots an act asks for. A file without code may be loaded to ask the act itself: an object stream does not say,
     * and a script tells what it needs of them.
     *
     * @throws BotException if it cannot be loaded
     */
    List<Role> roles(ActFile file) {
        return file.carriesCode() ? file.roles() : file.load(acts.trust()).roles();
    }

    /**
     * The behaviours that need no path and can be given to each of some robots, as far as can be told of one robot.
     *
     * @return their names, sorted
     */
    List<String> namesFor(List<Member> members) {
        return acts.names().stream()
                .filter(name -> fits(name, members))
                .map(SessionRecord::quoted)
                .toList();
    }

    private boolean fits(String name, List<Member> members) {
        try {
            Role first = session.offers().find(name).roles().get(0);
            return members.stream().allMatch(member -> first.unfit(member.bot()).isEmpty());
        } catch (BotException e) {
            return false;
        }
    }

    private Found file(String name) {
        ActFile file = acts.find(name);
        if (!acts.trust().isTrusted(file)) {
            throw new BotException(name + ": it brings code of its own; \"trust " + SessionRecord.quoted(name)
                    + "\" shows whose and lets you agree");
        }
        return file.carriesCode()
                ? new Found(file.details().name(), file.roles(), Optional.empty(), () -> file.load(acts.trust()))
                : new Found(file.details().name(), file.load(acts.trust()));
    }
}
