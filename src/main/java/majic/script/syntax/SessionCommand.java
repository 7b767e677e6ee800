package majic.script.syntax;

import java.util.OptionalInt;
import org.jspecify.annotations.Nullable;

/** A command for the session as a whole. */
public sealed interface SessionCommand {
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
    }

    /** Stops robots, closes them and removes them from the team. */
    record Remove(Robots robots) implements SessionCommand {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.remove(this);
        }
    }

    /** Lists the robots and their states. */
    record Bots() implements SessionCommand {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.bots(this);
        }
    }

    /** Reports what answers at an address. */
    record Probe(Literal address) implements SessionCommand {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.probe(this);
        }
    }

    /** Lists the behaviours there are, or describes one. */
    record Acts(@Nullable Literal act) implements SessionCommand {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.acts(this);
        }
    }

    /** Lists the files to whose code the user has agreed. */
    record Consents() implements SessionCommand {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.consents(this);
        }
    }

    /** Shows what a behaviour brings; with the beginning of its hash the user agrees to that. */
    record Trust(Literal act, @Nullable Literal hash) implements SessionCommand {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.trust(this);
        }
    }

    /** Takes the consent to a file back; the file may be gone, and is named by its hash then. */
    record TrustOff(Literal fileOrHash) implements SessionCommand {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.trustOff(this);
        }
    }

    /** Allows motion again after STOP. */
    record Release() implements SessionCommand {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.release(this);
        }
    }

    /** Runs a script from a file. */
    record Run(Literal file) implements SessionCommand {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.run(this);
        }
    }

    /** Writes what was done in the session as a script. */
    record SaveSession(Literal file) implements SessionCommand {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.saveSession(this);
        }
    }

    /** Writes the parameter log as CSV. */
    record SaveLog(Literal file) implements SessionCommand {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.saveLog(this);
        }
    }

    /** Writes the robots of the team as a script that adds them. */
    record SaveTeam(Literal file) implements SessionCommand {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.saveTeam(this);
        }
    }

    /** Lists the true poses in the simulated lab. */
    record Lab() implements SessionCommand {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.lab(this);
        }
    }

    /** Describes the language, or one word of it. */
    record Help(@Nullable Token topic) implements SessionCommand {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.help(this);
        }
    }

    /** Ends MAJIC. */
    record Quit() implements SessionCommand {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.quit(this);
        }
    }

    /** STOP: stops all robots and latches. */
    record StopAll() implements SessionCommand {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.stopAll(this);
        }
    }

    /** Waits for all robots of the script. */
    record Await() implements SessionCommand {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.await(this);
        }
    }

    /** Lets time pass. */
    record Pause(Literal time) implements SessionCommand {
        @Override
        public <R> R accept(Visitor<R> visitor) {
            return visitor.pause(this);
        }
    }
}
