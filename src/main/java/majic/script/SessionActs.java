package majic.script;

import java.nio.file.Path;
import java.time.ZoneId;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Function;
import java.util.function.Supplier;
import majic.act.ActArgument;
import majic.act.ActRun;
import majic.act.MajicAct;
import majic.act.Role;
import majic.act.file.ActCatalog;
import majic.act.file.ActFile;
import majic.act.file.ActTrust;
import majic.bot.BotException;
import majic.bot.MajicBot;
import majic.bot.MotionStopped;
import majic.bot.Value;
import majic.driver.Permit;
import majic.log.Line;
import majic.log.SessionOutput;
import majic.script.acts.ActArguments;
import majic.script.acts.RoleAssignment;
import majic.script.record.SessionRecord;
import majic.script.run.ActCall;
import majic.script.run.ActRunner;
import majic.script.run.Command;
import majic.script.run.Execution;
import majic.script.run.Plotting;
import majic.script.syntax.Literal;
import majic.team.Member;
import majic.team.Owner;
import majic.team.QueuedCommand;
import majic.team.Team;
import majic.time.Signal;
import org.jspecify.annotations.Nullable;

/** Runs behaviours on the robots of a session: finds them, assigns robots to roles, ends them. Thread-safe. */
final class SessionActs implements ActRunner {
    private static final int SHORTEST_HASH = 8;

    private final Team team;
    private final SessionOutput output;
    private final ActCatalog acts;
    private final ActOffers offers;
    private final Plotting plotting;
    private final List<ActRun> running = new CopyOnWriteArrayList<>();

    /** By robot, the permit of all that was ordered since its last {@code act off} and may still wait for its turn. */
    private final Map<Member, Permit> ordered = new ConcurrentHashMap<>();

    SessionActs(Team team, SessionOutput output, ActCatalog acts, ActOffers offers, Plotting plotting) {
        this.team = team;
        this.output = output;
        this.acts = acts;
        this.offers = offers;
        this.plotting = plotting;
    }

    /**
     * A behaviour whose file was read.
     *
     * @param name what messages call it
     * @param roles the robots it needs
     * @param arguments the values it may be given
     * @param fresh makes one to run; reads no file
     * @param isScript whether it is a script, whose commands can be checked
     */
    private record Found(
            String name, List<Role> roles, List<ActArgument> arguments, Supplier<MajicAct> fresh, boolean isScript) {
        /** For an act of one of MAJIC's own classes. */
        static Found of(String name, Supplier<MajicAct> fresh) {
            MajicAct act = fresh.get();
            return new Found(name, act.roles(), act.arguments(), fresh, act instanceof ScriptAct);
        }

        /** Makes one with values for its arguments. */
        MajicAct fresh(Map<String, Value> values) {
            MajicAct act = fresh.get();
            values.forEach(act::setArgument);
            return act;
        }

        /** Its name with values: {@code Wander speed=200mm/s}. */
        String titled(Map<String, Value> values) {
            StringBuilder text = new StringBuilder(name);
            values.forEach((argument, value) ->
                    text.append(' ').append(argument).append('=').append(ActArgument.typed(value)));
            return text.toString();
        }
    }

    @Override
    public CheckedAct read(ActCall call) {
        return call.name().at().resolve(() -> new FoundAct(call, find(call.name())));
    }

    /** A behaviour that a line names. */
    private final class FoundAct implements CheckedAct {
        private final ActCall call;
        private final Found found;

        FoundAct(ActCall call, Found found) {
            this.call = call;
            this.found = found;
        }

        @Override
        public void check(Command.Check check) {
            call.name().at().check(() -> {
                Map<String, List<Member>> robots =
                        assign(check.robot(), check.selection().members(call.others()));
                Map<String, Value> values = values();
                if (found.isScript() && found.fresh(values) instanceof ScriptAct script) {
                    script.check(check.session(), robots);
                }
            });
        }

        private Map<String, Value> values() {
            return ActArguments.fit(found.arguments(), call.arguments());
        }

        @Override
        public Function<Member, QueuedCommand> commands(Execution execution) {
            List<Member> others = execution.selection().members(call.others());
            List<Permit> permits = others.stream().map(SessionActs.this::permit).toList();
            return me -> command(me, others, permits.stream().reduce(permit(me), Permit::and), execution);
        }

        private QueuedCommand command(Member me, List<Member> others, Permit permit, Execution execution) {
            QueuedCommand command = new QueuedCommand(call.text(), true, robot -> {
                Map<String, List<Member>> robots = assign(me, others);
                noticeIfOwn(call.name().unquoted(), me);
                long began = me.time().nanos();
                ActRun run = run(robots, permit, execution);
                String how = run.isLeftBehind() ? "left behind without a robot, it does not end" : "done";
                return List.of(call.text()
                        + String.format(
                                Locale.ROOT, ": %s (%.1f s)", how, me.time().secondsSince(began)));
            });
            return command.checkedBy(permit::check);
        }

        private ActRun run(Map<String, List<Member>> robots, Permit permit, Execution execution) {
            Map<String, Value> values = values();
            MajicAct fresh = found.fresh(values);
            ActRun run = new ActRun(fresh, found.name(), found.titled(values), robots, permit);
            run.usePlots(plotting::show);
            run.useMap(execution.session().map());
            run.useTeam(SessionActs.this::robot);
            if (fresh instanceof ScriptAct script) {
                script.enter(execution, run.owner(), robots);
            }
            SessionActs.this.run(run, execution.owner());
            return run;
        }

        private Map<String, List<Member>> assign(Member me, List<Member> others) {
            return RoleAssignment.assign(call.name().unquoted(), found.roles(), me, others);
        }
    }

    private void noticeIfOwn(String name, Member me) {
        if (acts.replacesShipped(name)) {
            output.send(
                    Line.Kind.NOTICE,
                    me.number() + ": " + name + " from " + acts.folder()
                            + ", in place of the one that comes with MAJIC");
        }
    }

    private MajicBot robot(String name) {
        return team.members().stream()
                .filter(member -> name.equals(String.valueOf(member.number()))
                        || !name.isEmpty() && member.name().equalsIgnoreCase(name))
                .findFirst()
                .map(Member::bot)
                .orElseThrow(() -> new BotException("there is no robot " + name));
    }

    private Permit permit(Member member) {
        return member.currentPermit().and(ordered.computeIfAbsent(member, its -> new Permit()));
    }

    private void run(ActRun run, @Nullable Owner by) {
        running.add(run);
        try {
            run.run(by);
        } finally {
            running.remove(run);
            team.changes().raise();
        }
    }

    @Override
    public QueuedCommand callOff(Member member) {
        Permit before = ordered.remove(member);
        if (before != null) {
            before.revoke(() -> new MotionStopped("called off"));
        }
        List<ActRun> its =
                running.stream().filter(run -> run.owner() == member.owner()).toList();
        its.forEach(ActRun::callOff);
        return new QueuedCommand("act off", false, robot -> {
            awaitEnd(its);
            return List.of("act off: " + (its.isEmpty() ? "no act runs on it" : "done"));
        });
    }

    private void awaitEnd(List<ActRun> ending) {
        try {
            team.changes().await(() -> ending.stream().noneMatch(running::contains), Signal.FOR_EVER);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    @Override
    public List<String> list() {
        List<String> names = acts.names();
        return names.isEmpty()
                ? List.of("acts: none; \"1 act FILE\" takes any file that ends in " + ActCatalog.ENDING + " or "
                        + ScriptAct.ENDING)
                : names.stream().map(this::listed).toList();
    }

    private String listed(String name) {
        try {
            ActOffer offer = offers.find(name);
            String roles =
                    String.join(", ", offer.roles().stream().map(Role::toString).toList());
            String own = acts.replacesShipped(name) ? " (your own, in place of the one that comes with MAJIC)" : "";
            return "acts: " + name + " (" + roles + "): " + offer.details().description() + arguments(offer) + own;
        } catch (BotException e) {
            return "acts: " + name + ": " + e.getMessage();
        }
    }

    @Override
    public List<String> describe(String name) {
        ActOffer offer = offers.find(name);
        String start = "acts: " + offer.details().name() + ": ";
        List<String> lines = new ArrayList<>();
        lines.add(start + offer.details().description());
        offer.roles().forEach(role -> lines.add(start + "needs " + role));
        offer.arguments().forEach(argument -> lines.add(start + "takes " + argument));
        return lines;
    }

    private static String arguments(ActOffer offer) {
        List<String> names = offer.arguments().stream().map(ActArgument::name).toList();
        return names.isEmpty() ? "" : " Arguments: " + String.join(", ", names) + ".";
    }

    @Override
    public List<String> trust(String name, String hash) {
        ActFile file = acts.find(name);
        if (acts.trust().isTrusted(file)) {
            return List.of("trust " + name + ": agreed to already");
        }
        List<String> lines = new ArrayList<>();
        if (hash.isEmpty()) {
            file.describe().forEach(line -> lines.add("trust " + name + ": " + line));
            // In quotes, as many a hash begins like a number.
            lines.add("trust " + name + ": its code can do all that you can; if you agree: trust "
                    + SessionRecord.quoted(name) + " \"" + file.sha256().substring(0, SHORTEST_HASH) + '"');
        } else if (hash.length() < SHORTEST_HASH || !file.sha256().startsWith(hash.toLowerCase(Locale.ROOT))) {
            throw new BotException("trust " + name + ": the hash of this file is " + file.sha256());
        } else {
            acts.agree(file, name);
            lines.add("trust " + name + ": done");
        }
        return lines;
    }

    @Override
    public List<String> consents() {
        List<ActTrust.Consent> consents = acts.trust().consents();
        return consents.isEmpty()
                ? List.of("trust: there is no consent to the code of an act")
                : consents.stream().map(SessionActs::described).toList();
    }

    private static String described(ActTrust.Consent consent) {
        String since = consent.since()
                .map(time -> " since " + time.atZone(ZoneId.systemDefault()).toLocalDate())
                .orElse("");
        String file = consent.file().isEmpty() ? "" : ", file " + consent.file();
        return "trust: " + consent.act() + since + file + "; to end it: trust off \""
                + consent.sha256().substring(0, SHORTEST_HASH) + '"';
    }

    @Override
    public String trustOff(String nameOrHash) {
        boolean agreed = acts.trust().takeBack(hashOf(nameOrHash));
        return "trust off " + nameOrHash + ": " + (agreed ? "done" : "there was no consent for that file");
    }

    @Override
    public void checkNamed(String name) {
        acts.find(name);
    }

    @Override
    public void checkHash(String nameOrHash) {
        hashOf(nameOrHash);
    }

    @Override
    public String replayName(Literal name) {
        String text = name.unquoted();
        return ActCatalog.isFile(text)
                ? SessionRecord.quoted(
                        acts.locate(text).orElseThrow().toAbsolutePath().toString())
                : name.text();
    }

    /** The hash that was typed, the one with a consent that begins as was typed, or that of the file. */
    private String hashOf(String nameOrHash) {
        String typed = nameOrHash.toLowerCase(Locale.ROOT);
        if (typed.matches("[0-9a-f]{64}")) {
            return typed;
        }
        List<String> begun = typed.length() < SHORTEST_HASH
                ? List.of()
                : acts.trust().consents().stream()
                        .map(ActTrust.Consent::sha256)
                        .filter(hash -> hash.startsWith(typed))
                        .toList();
        return begun.size() == 1 ? begun.get(0) : acts.find(nameOrHash).sha256();
    }

    private Found find(Literal name) {
        String text = name.unquoted();
        return offers.scriptAt(text).map(SessionActs::script).orElseGet(() -> file(text));
    }

    private static Found script(Path path) {
        ScriptAct act = ScriptAct.read(path);
        String name = act.title().substring(0, act.title().length() - ScriptAct.ENDING.length());
        return Found.of(name, () -> new ScriptAct(act.title(), act.text()));
    }

    private Found file(String name) {
        ActFile file = acts.find(name);
        if (!acts.trust().isTrusted(file)) {
            throw new BotException(name + ": it brings code of its own; \"trust " + SessionRecord.quoted(name)
                    + "\" shows whose and lets you agree");
        }
        return file.carriesCode()
                ? new Found(file.details().name(), file.roles(), file.arguments(), () -> file.load(acts.trust()), false)
                : Found.of(file.details().name(), () -> file.load(acts.trust()));
    }
}
