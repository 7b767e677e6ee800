package majic.script;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import majic.act.ActDetails;
import majic.act.Role;
import majic.act.file.ActCatalog;
import majic.act.file.ActFile;
import majic.bot.BotException;
import majic.log.Line;
import majic.log.SessionOutput;
import majic.script.help.Completion;
import majic.script.record.SessionRecord;
import majic.team.Member;

/**
 * The behaviours a person can choose from, and the consent to their code. Everything here reads files and may wait;
 * nothing here loads any of an act's code.
 */
public final class ActOffers implements Completion.ActNames {
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
    @Override
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
            return new ActOffer(called, new ActDetails(name, "", "", "A script."), act.roles(), null);
        }
        ActFile file = acts.find(called);
        return new ActOffer(called, file.details(), file.roles(), file);
    }

    /**
     * Whether the person has to agree to its code before it can be loaded.
     *
     * @param offer the behaviour
     * @return false for scripts, for what came with MAJIC, and after {@link #agree}
     */
    public boolean needsConsent(ActOffer offer) {
        ActFile file = offer.file();
        return file != null && !acts.trust().isTrusted(file);
    }

    /**
     * The person has seen what it brings and agrees to its code, now and later. The session log keeps that.
     *
     * @param offer the behaviour; a script needs no consent
     * @throws BotException if that could not be written down; it then holds until the program ends
     */
    public void agree(ActOffer offer) {
        ActFile file = offer.file();
        if (file != null) {
            output.send(Line.Kind.NOTICE, "trust " + offer.called() + ": agreed to its code, SHA-256 " + file.sha256());
            acts.trust().agree(file);
        }
    }

    /** The file of a script that goes by a name or path; empty if an act does. */
    Optional<Path> scriptAt(String name) {
        return acts.locate(name).filter(path -> ActCatalog.isScript(path.toString()));
    }

    /**
     * The behaviours that need no path and can be loaded onto each of some robots, as far as one robot shows.
     *
     * @return their names, sorted
     */
    @Override
    public List<String> namesFor(List<Member> members) {
        return acts.names().stream()
                .filter(name -> fits(name, members))
                .map(SessionRecord::quoted)
                .toList();
    }

    private boolean fits(String name, List<Member> members) {
        try {
            Role first = find(name).roles().get(0);
            return members.stream().allMatch(member -> first.unfit(member.bot()).isEmpty());
        } catch (BotException e) {
            return false;
        }
    }
}
