package majic.gui.acts;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import majic.act.ActDetails;
import majic.act.file.ActCatalog;
import majic.act.file.ActFile;
import majic.act.file.ActTrust;
import majic.act.make.ActMaker;
import majic.environment.Settings;
import majic.script.ScriptAct;

/** The user's own acts in the window's tests. */
public final class OwnActs {
    /** System property that is set as soon as any code of the class {@code Spy} runs. */
    public static final String FLAG = "majic.test.spy";

    /** A source from which no act can be made. */
    public static final String UNFIT = "public class Unfit { }";

    public static final String SPY = """
            import majic.act.MajicAct;

            public class Spy extends MajicAct {
                static {
                    System.setProperty("majic.test.spy", "loaded");
                }

                @Override
                protected void behave() {
                    say("here I am");
                    while (true) {
                        bot.move(70);
                        pause(0.1);
                    }
                }
            }
            """;

    private static final String TOGETHER = """
            import java.util.List;
            import majic.act.MajicAct;
            import majic.act.Role;

            public class Together extends MajicAct {
                @Override
                public List<Role> roles() {
                    return List.of(Role.any(Role.ME), Role.any("follower").orMore());
                }

                @Override
                protected void behave() {
                    robots("follower").forEach(robot -> robot.move(30));
                }
            }
            """;

    private final Path folder;
    private final ActTrust trust = new ActTrust(Settings.inMemory());

    public OwnActs(Path folder) {
        this.folder = folder;
    }

    public ActCatalog acts() {
        return new ActCatalog(folder, trust);
    }

    /** Adds a script as an act with a name. */
    public OwnActs script(String name, String... lines) throws IOException {
        ScriptAct act = new ScriptAct(name, String.join("\n", lines));
        Files.write(folder.resolve(name + ".act"), ActMaker.save(act, ActDetails.named(name)));
        return this;
    }

    /** Adds an act that moves without end. */
    public OwnActs endless(String name, int mm) throws IOException {
        return script(name, "repeat", "me move " + mm, "wait 100ms", "end");
    }

    /** Adds an act with code; making it loads another copy of its class, which is discarded. */
    public OwnActs spy() throws IOException {
        return spy("Spy");
    }

    /** Adds the same act under another name. */
    public OwnActs spy(String name) throws IOException {
        ActDetails details = new ActDetails(name, "1.0", "Mata Hari", "Looks around.");
        Files.write(
                folder.resolve(name + ".act"), ActMaker.from(source("Spy", SPY)).make("Spy", details));
        System.clearProperty(FLAG);
        return this;
    }

    /** Adds an act with a role for any number of robots; its code may run. */
    public OwnActs convoy() throws IOException {
        byte[] file = ActMaker.from(source("Together", TOGETHER)).make("Together", ActDetails.named("Together"));
        Files.write(folder.resolve("Together.act"), file);
        trust.agree(ActFile.of("Together", file));
        return this;
    }

    public Path source(String name, String text) throws IOException {
        return Files.writeString(folder.resolve(name + ".java"), text);
    }
}
