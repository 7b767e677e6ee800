package majic.act;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.Serializable;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.EnumSet;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.UUID;
import java.util.stream.Stream;
import majic.act.file.ActFile;
import majic.act.file.ActObjectInput;
import majic.act.file.ActTrust;
import majic.act.make.ActMaker;
import majic.environment.Settings;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Tests loading the object stream alone of an act whose class MAJIC has, with all kinds of plain values. */
@Tag("jdk")
class ActStreamTest {
    private static final ActTrust NOBODY_ASKED = new ActTrust(Settings.inMemory());

    static Stream<Serializable> plainValues() {
        return Stream.of(
                "text",
                1,
                2.5,
                'c',
                true,
                Pocket.Button.OPEN,
                UUID.fromString("00000000-0000-0000-0000-000000000006"),
                Duration.ofMillis(1500),
                new ArrayList<>(List.of(1, "two", List.of(3.0))),
                new LinkedList<>(Set.of(1L)),
                new TreeMap<>(Map.of("key", new ArrayList<>())),
                new HashMap<>(Map.of(1, Map.of("in", "it"))),
                new LinkedHashMap<>(Map.of('a', (short) 1)),
                new TreeSet<>(Set.of((byte) 1)),
                new EnumMap<>(Map.of(Pocket.Button.SHUT, 1.5f)),
                EnumSet.allOf(Pocket.Button.class),
                (Serializable) Arrays.asList("one", "two"),
                (Serializable) List.of("same", "same", new ArrayList<>()));
    }

    @ParameterizedTest
    @MethodSource("plainValues")
    void anActKeepsPlainValues(Serializable value) throws IOException {
        MajicAct act = ActFile.of("pocket.act", Pocket.with(value)).load(NOBODY_ASKED);
        assertThat(act).isInstanceOfSatisfying(Pocket.class, pocket -> {
            assertThat(pocket.held).isEqualTo(value);
            assertThat(pocket.button).isEqualTo(Pocket.Button.SHUT);
        });
    }

    @Test
    void anActKeepsArrays() throws IOException {
        int[][] table = {{1, 2}, {3}};
        Pocket act = (Pocket) ActFile.of("pocket.act", Pocket.with(table)).load(NOBODY_ASKED);
        assertThat((int[][]) act.held).isDeepEqualTo(table);
    }

    @Test
    void anActKeepsACollectionThatIsInTwoPlaces() throws IOException {
        List<Integer> shared = new ArrayList<>(List.of(1, 2));
        Serializable both = new ArrayList<>(List.of(shared, shared));
        Pocket act = (Pocket) ActFile.of("pocket.act", Pocket.with(both)).load(NOBODY_ASKED);
        assertThat((List<?>) act.held)
                .hasSize(2)
                .allSatisfy(one -> assertThat(one).isSameAs(((List<?>) act.held).get(0)));
    }

    @Test
    void everyLoadGivesANewActWithAThreadOfItsOwn() throws IOException {
        ActFile file = ActFile.of("pocket.act", Pocket.with(new ArrayDeque<>(List.of(1))));
        Pocket one = (Pocket) file.load(NOBODY_ASKED);
        Pocket other = (Pocket) file.load(NOBODY_ASKED);
        assertThat(one).isNotSameAs(other);
        assertThat(one.held).isNotSameAs(other.held);
        assertThat(one.getState()).isEqualTo(Thread.State.NEW);
        assertThat(one.getId()).isNotEqualTo(other.getId());
    }

    @Test
    void nothingOfTheThreadIsSaved() throws IOException {
        byte[] stream = Pocket.with("held");
        List<String> classes = new ArrayList<>();
        ActObjectInput.read(stream, classes::add, ActFile.MAJIC);
        assertThat(classes)
                .containsExactly(Pocket.class.getName(), MajicAct.class.getName(), Pocket.Button.class.getName());
        assertThat(new String(stream, StandardCharsets.ISO_8859_1)).doesNotContain("lease", "Thread", "TimeSource");
    }

    @Test
    void itSaysWhatItIsWithoutAManifest() throws IOException {
        ActFile file = ActFile.of("pocket.act", Pocket.with(1));
        assertThat(file.details()).isEqualTo(ActDetails.named("Pocket"));
        assertThat(file.roles()).containsExactly(Role.any(Role.ME));
        assertThat(file.carriesCode()).isFalse();
        assertThat(NOBODY_ASKED.isTrusted(file)).isTrue();
    }

    @Test
    void aClassThatMajicHasNotIsNamed() throws IOException {
        byte[] stream = renamed(Pocket.with(1), "majic.act.Pocket", "majic.act.Rocket");
        assertThatThrownBy(() -> ActFile.of("bad.act", stream))
                .hasMessage(
                        "bad.act is an act of the class majic.act.Rocket, which is neither in it nor in this MAJIC");
    }

    @Test
    void anotherVersionOfTheClassIsToldFromDamage() throws IOException {
        byte[] stream = Pocket.with(1);
        int versionAt = 4 + 2 + 2 + "majic.act.Pocket".length();
        stream[versionAt + 7] = 9;
        assertThatThrownBy(() -> ActFile.of("old.act", stream))
                .hasMessage("old.act was saved with another version of the class majic.act.Pocket");
    }

    @Test
    void savedByTheMakerItCarriesRolesAndDetails() {
        byte[] file = ActMaker.save(new Pocket("held"), new ActDetails("Mine", "1", "Ada", ""));
        ActFile read = ActFile.of("mine.act", file);
        assertThat(read.carriesCode()).isFalse();
        assertThat(read.details().author()).isEqualTo("Ada");
        assertThat(((Pocket) read.load(NOBODY_ASKED)).held).isEqualTo("held");
    }

    private static byte[] renamed(byte[] stream, String from, String to) {
        String text = new String(stream, StandardCharsets.ISO_8859_1);
        return text.replace(from, to).getBytes(StandardCharsets.ISO_8859_1);
    }
}
