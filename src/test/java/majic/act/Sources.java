package majic.act;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import majic.act.file.ActFile;
import majic.act.file.ActTrust;
import majic.act.make.ActMaker;
import majic.environment.Settings;

/** Compiles acts while the tests run, so that this MAJIC does not have their classes. */
public final class Sources {
    /** Has a record, an enum whose constant has a body, a lambda and a helper beside it. */
    public static final String WANDER = """
            import java.util.List;
            import java.util.function.IntSupplier;
            import majic.act.MajicAct;
            import majic.act.Role;

            public class Wander extends MajicAct {
                static int loads;
                private final Step step = new Step(300);
                private final Mode mode = Mode.FAST;
                private final List<String> words = List.of("a", "b");

                enum Mode { SLOW, FAST { } }

                record Step(int mm) implements java.io.Serializable { }

                static {
                    System.setProperty("majic.test.wander", "loaded");
                    loads++;
                }

                @Override
                public List<Role> roles() {
                    return List.of(Role.any("me").types("aibo").with("distanceFront"));
                }

                @Override
                protected void behave() {
                    IntSupplier far = () -> new Helper().twice(step.mm());
                    bot.move(far.getAsInt());
                }
            }

            class Helper {
                int twice(int number) {
                    return 2 * number;
                }
            }
            """;

    private Sources() {}

    public static ActMaker maker(Path folder, String name, String text) {
        try {
            return ActMaker.from(Files.writeString(folder.resolve(name + ".java"), text));
        } catch (IOException e) {
            throw new AssertionError("a test's folder takes what is written to it", e);
        }
    }

    /** Returns the act file of a source; the class has the same name. */
    public static byte[] act(Path folder, String name, String text) {
        return maker(folder, name, text).make(name, ActDetails.named(name));
    }

    /** Returns a trust store with the consent to a file. */
    public static ActTrust trusting(ActFile file) {
        ActTrust trust = new ActTrust(Settings.inMemory());
        trust.agree(file);
        return trust;
    }
}
