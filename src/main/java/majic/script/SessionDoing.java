package majic.script;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Collection;
import java.util.List;
import java.util.Locale;
import majic.bot.BotException;
import majic.bot.IoReason;
import majic.bot.Pose;
import majic.lab.LabAccess;
import majic.script.syntax.Literal;
import majic.script.syntax.SessionCommand;
import majic.team.Member;
import org.jspecify.annotations.Nullable;

/** Does what the session as a whole is told. */
final class SessionDoing implements SessionCommand.Visitor<@Nullable Void> {
    private final Execution execution;
    private final Session session;

    SessionDoing(Execution execution) {
        this.execution = execution;
        this.session = execution.session();
    }

    @Override
    public @Nullable Void add(SessionCommand.Add add) {
        Member member = session.comings().add(SessionCheck.text(add.address()), add.number());
        if (execution.isScript()) {
            execution.claim(List.of(member));
        }
        return null;
    }

    @Override
    public @Nullable Void remove(SessionCommand.Remove remove) {
        List<Member> members = execution.selection().members(remove.robots());
        if (!execution.isTyped()) {
            execution.awaitFinished(members);
        }
        for (Member member : members) {
            session.comings().remove(member);
        }
        return null;
    }

    @Override
    public @Nullable Void bots(SessionCommand.Bots bots) {
        Roll.of(session).forEach(this::answer);
        return null;
    }

    @Override
    public @Nullable Void probe(SessionCommand.Probe probe) {
        String address = SessionCheck.text(probe.address());
        answer("probe " + address + ": " + session.factory().probe(address));
        return null;
    }

    @Override
    public @Nullable Void acts(SessionCommand.Acts acts) {
        session.behaviours().list().forEach(this::answer);
        return null;
    }

    @Override
    public @Nullable Void trust(SessionCommand.Trust trust) {
        if (execution.isScript()) {
            throw new BotException("trust: only a person agrees to an act's code, not a script");
        }
        Literal hash = trust.hash();
        String act = SessionCheck.text(trust.act());
        session.behaviours()
                .trust(act, hash == null ? "" : SessionCheck.text(hash))
                .forEach(this::answer);
        return null;
    }

    @Override
    public @Nullable Void trustOff(SessionCommand.TrustOff trustOff) {
        answer(session.behaviours().trustOff(SessionCheck.text(trustOff.fileOrHash())));
        return null;
    }

    @Override
    public @Nullable Void release(SessionCommand.Release release) {
        session.team().release();
        return null;
    }

    @Override
    public @Nullable Void run(SessionCommand.Run run) {
        ScriptFile.run(SessionCheck.path(run.file()), execution);
        return null;
    }

    @Override
    public @Nullable Void saveSession(SessionCommand.SaveSession save) {
        save(save.file(), "session", path -> session.record().save(path));
        return null;
    }

    @Override
    public @Nullable Void saveLog(SessionCommand.SaveLog save) {
        if (!execution.isTyped()) {
            execution.awaitLogging();
        }
        if (session.parameterLog().isEmpty()) {
            throw new BotException("save log: there are no readings yet; \"1 log x every 100ms\" takes some");
        }
        save(save.file(), "log", path -> session.parameterLog().save(path));
        return null;
    }

    /** Writes a file. */
    private interface Saving {
        void to(Path path) throws IOException;
    }

    private void save(Literal file, String what, Saving saving) {
        Path path = SessionCheck.path(file);
        try {
            saving.to(path);
        } catch (IOException e) {
            throw new BotException(path + ": cannot be written (" + IoReason.of(e) + ")", e);
        }
        answer("save " + what + " " + file.text() + ": done");
    }

    @Override
    public @Nullable Void lab(SessionCommand.Lab lab) {
        LabAccess running = session.factory().lab().orElseThrow();
        running.truePoses().forEach((type, pose) -> answer("lab: " + type + " " + place(pose)));
        return null;
    }

    private static String place(Pose pose) {
        double heading = Math.round(pose.headingDeg() * 10) / 10.0;
        return String.format(
                Locale.ROOT, "x=%d y=%d heading=%.1f", Math.round(pose.xMm()), Math.round(pose.yMm()), heading);
    }

    @Override
    public @Nullable Void help(SessionCommand.Help help) {
        Help.of(session, help.topic()).forEach(this::answer);
        return null;
    }

    @Override
    public @Nullable Void quit(SessionCommand.Quit quit) {
        session.quit();
        return null;
    }

    @Override
    public @Nullable Void stopAll(SessionCommand.StopAll stop) {
        execution.stopEverything();
        return null;
    }

    @Override
    public @Nullable Void await(SessionCommand.Await await) {
        Collection<Member> all = execution.everybody();
        execution.awaitFinished(all);
        execution.recording().waitedForAll(all);
        return null;
    }

    @Override
    public @Nullable Void pause(SessionCommand.Pause pause) {
        execution.pause(pause.time().value().number());
        return null;
    }

    private void answer(String text) {
        execution.say(Line.Kind.ANSWER, text);
    }
}
