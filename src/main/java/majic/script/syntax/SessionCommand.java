package majic.script.syntax;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import org.jspecify.annotations.Nullable;

/** A command for the session as a whole. */
public sealed interface SessionCommand extends Instruction {
    /** Why a behaviour may contain hardly any of them. */
    Optional<String> REFUSED_IN_ACT = Optional.of("is for a session; an act only commands the robots it is given");

    @Override
    default Optional<String> refusalInAct() {
        return REFUSED_IN_ACT;
    }

    <R> R accept(Visitor<R> visitor);

    /** One method for each command. */
    interface Visitor<R> {
        R add(Add add);

        R remove(Remove remove);

        R bots(Bots bots);

        R probe(Probe probe);

        R acts(Acts acts);

        R consents(Consents consents);

        R trust(Trust trust);

        R trustOff(TrustOff trustOff);

        R release(Release release);

        R run(Run run);

        R saveSession(SaveSession save);

        R saveLog(SaveLog save);

        R saveTeam(SaveTeam save);

        R lab(Lab lab);

        R help(Help help);

        R quit(Quit quit);

        R stopAll(StopAll stop);

        R await(Await await);

        R pause(Pause pause);
    }

    /** Connects to a robot and adds it to the team. */
    record Add(Literal address, OptionalInt number) implements SessionCommand {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.add(this);
        }

        @Override
        public Scheduling scheduling() {
            return Scheduling.BESIDE_IN_ORDER;
        }

        @Override
        public List<CommandTrait> traits() {
            return List.of(CommandTrait.CHANGES_TEAM);
        }

        @Override
        public Optional<String> refusalInAct() {
            return Optional.empty();
        }
    }

    /** Stops robots, closes them and removes them from the team. */
    record Remove(Robots robots) implements SessionCommand {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.remove(this);
        }

        @Override
        public Scheduling scheduling() {
            return Scheduling.BESIDE;
        }

        @Override
        public List<CommandTrait> traits() {
            return List.of(CommandTrait.CHANGES_TEAM);
        }
    }

    /** Lists the robots and their states. */
    record Bots() implements SessionCommand {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.bots(this);
        }

        @Override
        public Scheduling scheduling() {
            return Scheduling.OVERTAKES;
        }
    }

    /** Reports what answers at an address. */
    record Probe(Literal address) implements SessionCommand {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.probe(this);
        }

        @Override
        public Scheduling scheduling() {
            return Scheduling.BESIDE;
        }
    }

    /** Lists the behaviours there are, or describes one. */
    record Acts(@Nullable Literal act) implements SessionCommand {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.acts(this);
        }

        @Override
        public Scheduling scheduling() {
            return Scheduling.BESIDE;
        }

        @Override
        public List<CommandTrait> traits() {
            return List.of(CommandTrait.READS_FILES);
        }
    }

    /** Lists the files to whose code the user has agreed. */
    record Consents() implements SessionCommand {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.consents(this);
        }

        @Override
        public Scheduling scheduling() {
            return Scheduling.BESIDE;
        }

        @Override
        public List<CommandTrait> traits() {
            return List.of(CommandTrait.LOCAL_ONLY);
        }
    }

    /** Shows what a behaviour brings; with the beginning of its hash the user agrees to that. */
    record Trust(Literal act, @Nullable Literal hash) implements SessionCommand {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.trust(this);
        }

        @Override
        public Scheduling scheduling() {
            return Scheduling.BESIDE;
        }

        @Override
        public List<CommandTrait> traits() {
            return List.of(CommandTrait.READS_FILES, CommandTrait.CHANGES_TEAM, CommandTrait.LOCAL_ONLY);
        }
    }

    /** Takes the consent to a file back; the file may be gone, and is named by its hash then. */
    record TrustOff(Literal fileOrHash) implements SessionCommand {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.trustOff(this);
        }

        @Override
        public Scheduling scheduling() {
            return Scheduling.BESIDE;
        }

        @Override
        public List<CommandTrait> traits() {
            return List.of(CommandTrait.READS_FILES, CommandTrait.CHANGES_TEAM, CommandTrait.LOCAL_ONLY);
        }
    }

    /** Allows motion again after STOP. */
    record Release() implements SessionCommand {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.release(this);
        }

        @Override
        public Scheduling scheduling() {
            return Scheduling.OVERTAKES;
        }
    }

    /** Runs a script from a file. */
    record Run(Literal file) implements SessionCommand {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.run(this);
        }

        @Override
        public Scheduling scheduling() {
            return Scheduling.BESIDE;
        }

        @Override
        public List<CommandTrait> traits() {
            return List.of(CommandTrait.COMMANDS_ROBOTS, CommandTrait.READS_FILES, CommandTrait.CHANGES_TEAM);
        }
    }

    /** Writes what was done in the session as a script. */
    record SaveSession(Literal file) implements SessionCommand {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.saveSession(this);
        }

        @Override
        public Scheduling scheduling() {
            return Scheduling.BESIDE;
        }

        @Override
        public List<CommandTrait> traits() {
            return List.of(CommandTrait.WRITES_FILE);
        }
    }

    /** Writes the parameter log as CSV. */
    record SaveLog(Literal file) implements SessionCommand {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.saveLog(this);
        }

        @Override
        public Scheduling scheduling() {
            return Scheduling.BESIDE;
        }

        @Override
        public List<CommandTrait> traits() {
            return List.of(CommandTrait.WRITES_FILE);
        }
    }

    /** Writes the robots of the team as a script that adds them. */
    record SaveTeam(Literal file) implements SessionCommand {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.saveTeam(this);
        }

        @Override
        public Scheduling scheduling() {
            return Scheduling.BESIDE;
        }

        @Override
        public List<CommandTrait> traits() {
            return List.of(CommandTrait.WRITES_FILE);
        }
    }

    /** Lists the true poses in the simulated lab. */
    record Lab() implements SessionCommand {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.lab(this);
        }

        @Override
        public Scheduling scheduling() {
            return Scheduling.AT_ONCE;
        }
    }

    /** Describes the language, or one word of it. */
    record Help(@Nullable Token topic) implements SessionCommand {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.help(this);
        }

        @Override
        public Scheduling scheduling() {
            return Scheduling.OVERTAKES;
        }
    }

    /** Ends MAJIC. */
    record Quit() implements SessionCommand {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.quit(this);
        }

        @Override
        public Scheduling scheduling() {
            return Scheduling.OVERTAKES;
        }
    }

    /** STOP: stops all robots and latches. */
    record StopAll() implements SessionCommand {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.stopAll(this);
        }

        @Override
        public Scheduling scheduling() {
            return Scheduling.STOP;
        }

        @Override
        public Optional<String> refusalInAct() {
            return Optional.empty();
        }
    }

    /** Waits for all robots of the script. */
    record Await() implements SessionCommand {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.await(this);
        }

        @Override
        public Scheduling scheduling() {
            return Scheduling.HOLDS;
        }

        @Override
        public Optional<String> refusalInAct() {
            return Optional.empty();
        }
    }

    /** Lets time pass. */
    record Pause(Literal time) implements SessionCommand {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.pause(this);
        }

        @Override
        public Scheduling scheduling() {
            return Scheduling.HOLDS;
        }

        @Override
        public Optional<String> refusalInAct() {
            return Optional.empty();
        }
    }
}
