package majic.script;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import majic.act.ActArgument;
import majic.act.ActDetails;
import majic.act.Role;
import majic.act.file.ActCatalog;
import majic.act.file.ActFile;
import majic.bot.BotException;
import majic.log.Line;
import majic.log.SessionOutput;
import majic.script.help.Completer;
import majic.script.help.Completion;
import majic.script.record.SessionRecord;
import majic.team.Member;

/**
 * The behaviours that the user can choose from, and the consent to their code. Everything here reads files and may
 * wait; nothing here loads any of an act's code.
 */
public final class ActOffers implements Completer.Acts {
    private final SessionOutput output;
    private final ActCatalog acts;

    ActOffers(SessionOutput output, ActCatalog acts) {
        this.output = output;
        this.acts = acts;
    }

    /**
     * The behaviours that need no path.
     *
     * @return their names, sorted
     * @throws BotException if the user's folder cannot be read
     */
    public List<String> names() {
        return acts.names();
    }

    /**
     * Where the user's own behaviours lie.
     *
     * @return a folder that need not exist
     */
    public Path folder() {
        return acts.folder();
    }

    /**
     * Reads the description of a behaviour.
     *
     * @param called its name, or the path of an act's file or of a script
     * @return what it is
     * @throws BotException if there is none, or it cannot be a behaviour; a script's mistakes are a line each
     */
    public ActOffer find(String called) {
        if (called.contains("\"")) {
            throw new BotException(called + ": a file whose name has a quotation mark in it cannot be used here");
        }
        Optional<Path> script = scriptAt(called);
        if (script.isPresent()) {
            ScriptAct act = ScriptAct.read(script.get());
            String name = act.title().substring(0, act.title().length() - ScriptAct.ENDING.length());
            String description = act.description().isEmpty() ? "A script." : act.description();
            return new ActOffer(called, new ActDetails(name, "", "", description), act.roles(), act.arguments(), null);
        }
        ActFile file = acts.find(called);
        return new ActOffer(called, file.details(), file.roles(), file.arguments(), file);
    }

    /**
     * Whether the user has to agree to its code before it can be loaded.
     *
     * @param offer the behaviour
     * @return false for scripts, for what came with MAJIC, and after {@link #agree}
     */
    public boolean needsConsent(ActOffer offer) {
        ActFile file = offer.file();
        return file != null && !acts.trust().isTrusted(file);
    }

    /**
     * The user has seen what it brings and agrees to its code, now and later. The session log keeps that.
     *
     * @param offer the behaviour; a script needs no consent
     * @throws BotException if that could not be written down; it then holds until the program ends
     */
    public void agree(ActOffer offer) {
        ActFile file = offer.file();
        if (file != null) {
            output.send(Line.Kind.NOTICE, "trust " + offer.called() + ": agreed to its code, SHA-256 " + file.sha256());
            acts.agree(file, offer.called());
        }
    }

    /** The file of a script that goes by a name or path; empty if an act does. */
    Optional<Path> scriptAt(String name) {
        return acts.locate(name).filter(path -> ActCatalog.isScript(path.toString()));
    }

    @Override
    public boolean isFile(String name) {
        return ActCatalog.isFile(name);
    }

    @Override
    public List<Completion> completions() {
        return completionsFor(List.of());
    }

    /**
     * The behaviours that need no path and can be loaded onto each of some robots, as far as one robot shows.
     *
     * @return their names and descriptions, sorted
     */
    @Override
    public List<Completion> completionsFor(List<Member> members) {
        return acts.names().stream()
                .flatMap(name -> completion(name, members).stream())
                .toList();
    }

    @Override
    public List<ActArgument> argumentsOf(String act) {
        try {
            return find(act).arguments();
        } catch (BotException e) {
            return List.of();
        }
    }

    /** Empty if the act cannot be read, or does not fit one of the robots. */
    private Optional<Completion> completion(String name, List<Member> members) {
        try {
            ActOffer offer = find(name);
            Role first = offer.roles().get(0);
            boolean fits = members.stream()
                    .allMatch(member -> first.unfit(member.bot()).isEmpty());
            return fits
                    ? Optional.of(new Completion(
                            SessionRecord.quoted(name), "", offer.details().description()))
                    : Optional.empty();
        } catch (BotException e) {
            return Optional.empty();
        }
    }
}
