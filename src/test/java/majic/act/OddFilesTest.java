package majic.act;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowable;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.io.Serializable;
import java.lang.annotation.RetentionPolicy;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.TreeMap;
import java.util.stream.Stream;
import majic.act.file.ActContents;
import majic.act.file.ActFile;
import majic.act.file.ActManifest;
import majic.act.file.ActTrust;
import majic.act.file.BoundedZipTest;
import majic.environment.Settings;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** Tests that a file that is not an act is refused in one sentence that begins with its name. */
@Tag("jdk")
class OddFilesTest {
    private static final String SCRIPT = "majic.script.ScriptAct";

    private record Pair(int one, String other) implements Serializable {}

    /** An act whose data is read without end. */
    private static final class Refusing extends MajicAct {
        private static final long serialVersionUID = 1;

        private void readObject(ObjectInputStream in) {
            throw new StackOverflowError();
        }

        @Override
        protected void behave() {}
    }

    private static byte[] saved(@Nullable Object one) {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (ObjectOutputStream out = new ObjectOutputStream(bytes)) {
            out.writeObject(one);
        } catch (IOException e) {
            throw new AssertionError("memory takes what is written to it", e);
        }
        return bytes.toByteArray();
    }

    private static byte[] stream(String hex) {
        return HexFormat.of().parseHex("aced0005" + hex.replace(" ", ""));
    }

    private static byte[] jar(String manifest, Map<String, byte[]> entries) {
        Map<String, byte[]> all = new TreeMap<>(entries);
        all.put(ActManifest.PATH, ("Manifest-Version: 1.0\n" + manifest).getBytes(StandardCharsets.UTF_8));
        return BoundedZipTest.zip(all);
    }

    private static byte[] jarOf(String actClass, byte[] data) {
        return jar("Act-Format: 1\nAct-Class: " + actClass + "\n", Map.of(ActContents.DATA, data));
    }

    private static byte[] nested(int levels) {
        byte[] zip = BoundedZipTest.zip(Map.of("zeros", new byte[3 << 20]));
        for (int level = 0; level < levels; level++) {
            Map<String, byte[]> copies = new TreeMap<>();
            for (int copy = 0; copy < 16; copy++) {
                copies.put("nested" + copy + ".jar", zip);
            }
            zip = BoundedZipTest.zip(copies);
        }
        return zip;
    }

    private static byte[] longerThanItIs(Object array) {
        byte[] stream = saved(array);
        byte[] length = HexFormat.of().parseHex("7870" + "00000001");
        for (int at = 0; at <= stream.length - length.length; at++) {
            if (Arrays.equals(stream, at, at + length.length, length, 0, length.length)) {
                ByteBuffer.wrap(stream).putInt(at + 2, Integer.MAX_VALUE);
                return stream;
            }
        }
        throw new AssertionError("an array of one element says so");
    }

    static Stream<Arguments> oddFiles() {
        return Stream.of(
                Arguments.of("nothing", new byte[0]),
                Arguments.of("one byte", new byte[] {1}),
                Arguments.of("half a head", new byte[] {(byte) 0xAC, (byte) 0xED, 0}),
                Arguments.of("a head only", stream("")),
                Arguments.of("text", "me move 100\n".getBytes(StandardCharsets.UTF_8)),
                Arguments.of("zeros", new byte[1 << 20]),
                Arguments.of("a stream of nothing", stream("70")),
                Arguments.of("a map", saved(new HashMap<>(Map.of("one", 1)))),
                Arguments.of("a list", saved(new ArrayList<>(List.of(1, 2)))),
                Arguments.of("a boxed number", saved(7)),
                Arguments.of("a text object", saved("text")),
                Arguments.of("a long text", saved("text".repeat(50_000))),
                Arguments.of("a record", saved(new Pair(1, "two"))),
                Arguments.of("a constant", saved(RetentionPolicy.CLASS)),
                Arguments.of("nothing saved", saved(null)),
                Arguments.of("numbers", saved(new int[] {1, 2})),
                Arguments.of("texts", saved(new String[] {"one"})),
                Arguments.of("acts", saved(new MajicAct[] {null})),
                Arguments.of("a class", saved(String.class)),
                Arguments.of("a failure", saved(new IllegalStateException("no"))),
                Arguments.of("many numbers that are not there", longerThanItIs(new int[] {1})),
                Arguments.of("many texts that are not there", longerThanItIs(new String[] {"one"})),
                Arguments.of("a long text that is not there", stream("7c 7fffffffffffffff 00")),
                Arguments.of("a text of a negative length", stream("7c ffffffffffffffff 00")),
                Arguments.of("bare data", stream("77 02 0102")),
                Arguments.of("much bare data that is not there", stream("7a 7fffffff 00")),
                Arguments.of("an object without a class", stream("73 70")),
                Arguments.of("an object of a class that comes later", stream("73 71 007e0005")),
                Arguments.of("a broken-off stream", stream("7b")),
                Arguments.of(
                        "a class with a name that is none", stream("73 72 0003 c0c1c2 0000000000000001 02 0000 78 70")),
                Arguments.of("a class without a name", stream("73 72 0000 0000000000000001 02 0000 78 70")),
                Arguments.of(
                        "a class that is its own parent",
                        stream("73 72 0001 41 0000000000000001 02 0000 78 71 007e0000")),
                Arguments.of(
                        "a class of many fields that are not there",
                        stream("73 72 0001 41 0000000000000001 02 ffff 78 70")),
                Arguments.of("a dynamic proxy", stream("73 7d 7fffffff 78 70")),
                Arguments.of("an act of Java's", saved(new Thread[] {null})),
                Arguments.of("a zip of nothing", BoundedZipTest.zip(Map.of())),
                Arguments.of("a zip without a manifest", BoundedZipTest.zip(Map.of("a", new byte[] {1}))),
                Arguments.of("a jar that is no act", jar("", Map.of())),
                Arguments.of("a jar without data", jar("Act-Format: 1\nAct-Class: " + SCRIPT + "\n", Map.of())),
                Arguments.of("a jar with a map", jarOf(SCRIPT, saved(new HashMap<>()))),
                Arguments.of("a jar with nothing saved", jarOf(SCRIPT, saved(null))),
                Arguments.of("a jar with empty data", jarOf(SCRIPT, new byte[0])),
                Arguments.of("a jar with numbers", jarOf(SCRIPT, saved(new int[] {1}))),
                Arguments.of("a jar with another act", jarOf(SCRIPT, saved(new Refusing()))),
                Arguments.of("an act that fails as it is read", jarOf(Refusing.class.getName(), saved(new Refusing()))),
                Arguments.of("an act of a class that is none", jarOf("[I", saved(new int[] {1}))),
                Arguments.of("an act of a class with blanks", jarOf("a b", saved(7))),
                Arguments.of("an act that is every act", jarOf(MajicAct.class.getName(), saved(7))),
                Arguments.of("an act of a class with slashes", jarOf("java/lang/String", saved("a"))),
                Arguments.of("an act of Java", jarOf("java.lang.Thread", saved(7))),
                Arguments.of("a manifest of one long line", jar("x".repeat(100_000), Map.of())),
                Arguments.of("a manifest of nothing", BoundedZipTest.zip(Map.of(ActManifest.PATH, new byte[0]))),
                Arguments.of(
                        "an empty class",
                        jar(
                                "Act-Format: 1\nAct-Class: A\n",
                                Map.of("A.class", new byte[0], ActContents.DATA, saved(7)))),
                Arguments.of(
                        "a class without a parent",
                        jar(
                                "Act-Format: 1\nAct-Class: A\n",
                                Map.of("A.class", TinyClass.of("A", 61), ActContents.DATA, saved(7)))),
                Arguments.of("zips in zips", nested(3)),
                Arguments.of(
                        "a jar with zips in zips",
                        jar(
                                "Act-Format: 1\nAct-Class: " + SCRIPT + "\n",
                                Map.of("bomb.zip", nested(2), ActContents.DATA, saved(7)))));
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("oddFiles")
    void isRefusedInOneSentence(String name, byte[] bytes) {
        assertThat(refusal(bytes)).isInstanceOf(ActException.class).satisfies(OddFilesTest::isOneSentence);
    }

    private static @Nullable Throwable refusal(byte[] bytes) {
        return catchThrowable(() -> ActFile.of("odd.act", bytes).load(new ActTrust(Settings.inMemory())));
    }

    private static void isOneSentence(Throwable refusal) {
        assertThat(refusal.getMessage())
                .startsWith("odd.act ")
                .doesNotContain("Exception", "java.io")
                .hasLineCount(1);
    }

    @Test
    void otherBytesAnywhereInAJarAreReadOrRefusedInOneSentence() {
        byte[] jar = jarOf(Pocket.class.getName(), saved(new Pocket(new ArrayList<>(List.of("one", 2)))));
        Random random = new Random(11);
        for (int round = 0; round < 3_000; round++) {
            byte[] other = jar.clone();
            for (int changes = 1 + random.nextInt(3); changes > 0; changes--) {
                other[random.nextInt(other.length)] = (byte) random.nextInt(256);
            }
            Throwable refusal = refusal(other);
            if (refusal != null) {
                assertThat(refusal).isInstanceOf(ActException.class).satisfies(OddFilesTest::isOneSentence);
            }
        }
    }
}
