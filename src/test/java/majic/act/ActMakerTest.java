package majic.act;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import majic.bot.Settings;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** From a source or compiled classes to a file that a MAJIC which has never seen the class can load. */
@Timeout(60)
class ActMakerTest {
    private static final ActDetails DETAILS = new ActDetails("Wander", "1.2", "Ada", "walks\nabout");

    @TempDir
    Path folder;

    static final String WANDER = """
            import java.util.List;
            import java.util.function.IntSupplier;
            import majic.act.MajicAct;
            import majic.act.Role;

            public class Wander extends MajicAct {
                private final Step step = new Step(300);
                enum Mode { SLOW, FAST { } }
                private final Mode mode = Mode.FAST;
                private final List<String> words = List.of("a", "b");

                record Step(int mm) implements java.io.Serializable { }

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

    private Path source(String name, String text) throws IOException {
        return Files.writeString(folder.resolve(name), text);
    }

    @Test
    void aSourceBecomesAFileThatLoads() throws IOException {
        ActMaker maker = ActMaker.from(source("Wander.java", WANDER));
        byte[] bytes = maker.make(maker.onlyAct(), DETAILS);
        ActFile file = ActFile.of("wander.act", bytes);
        ActTrust trust = new ActTrust(Settings.inMemory());
        trust.agree(file);
        MajicAct act = file.load(trust);
        assertThat(act.getClass().getName()).isEqualTo("Wander");
        assertThat(file.details()).isEqualTo(new ActDetails("Wander", "1.2", "Ada", "walks about"));
        assertThat(file.roles()).isEqualTo(List.of(Role.parse("me aibo (distanceFront)")));
        assertThat(file.classes()).containsExactly("Helper", "Wander", "Wander$Mode", "Wander$Mode$1", "Wander$Step");
        assertThat(file.packages()).contains("majic.act", "java.util.function");
    }
}
