package majic.act;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowable;

import java.io.IOException;
import java.io.ObjectInputStream;
import java.io.Serializable;
import java.lang.reflect.InvocationHandler;
import java.lang.reflect.Method;
import java.lang.reflect.Proxy;
import java.net.URL;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.rmi.MarshalledObject;
import java.rmi.server.ObjID;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Hashtable;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.PriorityQueue;
import java.util.Random;
import java.util.Set;
import java.util.TreeMap;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.management.BadAttributeValueExpException;
import javax.swing.event.EventListenerList;
import majic.act.file.ActContents;
import majic.act.file.ActFile;
import majic.act.file.ActManifest;
import majic.act.file.ActObjectInput;
import majic.act.file.ActTrust;
import majic.act.file.BoundedZipTest;
import majic.environment.Settings;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Tests that the forms of known deserialization attacks, in an act's field and alone, are refused and none of their
 * code runs.
 */
@Tag("jdk")
class HostileStreamsTest {
    private static final AtomicInteger RAN = new AtomicInteger();

    /** Represents classes of libraries that run code chosen by a stream. */
    private static final class Gadget
            implements Serializable, InvocationHandler, Comparator<Object>, Comparable<Object> {
        private static final long serialVersionUID = 1;

        private void readObject(ObjectInputStream in) {
            RAN.incrementAndGet();
        }

        private Object readResolve() {
            RAN.incrementAndGet();
            return this;
        }

        @Override
        public Object invoke(Object proxy, Method method, Object[] arguments) {
            return method.getName().equals("hashCode") ? 7 : (Object) RAN.incrementAndGet();
        }

        @Override
        public int compare(Object one, Object other) {
            return RAN.incrementAndGet();
        }

        @Override
        public int compareTo(Object other) {
            return RAN.incrementAndGet();
        }

        @Override
        public boolean equals(Object other) {
            return this == other;
        }

        @Override
        public int hashCode() {
            return RAN.incrementAndGet();
        }
    }

    /** A comparator that is a lambda is written as a SerializedLambda. */
    private interface SavedComparator extends Comparator<Object>, Serializable {}

    static Stream<Arguments> gadgets() throws Exception {
        Map<String, Serializable> shapes = new TreeMap<>();
        shapes.put("a class of a library", new Gadget());
        shapes.put("a gadget in an array", new Object[] {new Gadget()});
        shapes.put("an array of gadgets", new Gadget[] {new Gadget()});
        shapes.put("a gadget in a map", new HashMap<>(Map.of("key", new Gadget())));
        shapes.put("the key of a map (URLDNS)", new HashMap<>(Map.of(new URL("http://127.0.0.1/"), 1)));
        shapes.put("the key of a table", new Hashtable<>(Map.of(new Gadget(), 1)));
        shapes.put("a set with a proxy (Jdk7u21)", new LinkedHashSet<>(List.of("f5a5a608", proxy(Map.class))));
        shapes.put("a proxy (CommonsCollections1)", (Serializable) proxy(Map.class));
        shapes.put("a queue with a comparator (CommonsBeanutils)", queue(new Gadget()));
        shapes.put("a tree with a comparator", tree(new Gadget()));
        shapes.put("a lambda", (SavedComparator) (one, other) -> RAN.incrementAndGet());
        shapes.put(
                "a value that asks for its text (CommonsCollections5)",
                new BadAttributeValueExpException(new Gadget()));
        shapes.put("an exception", new IllegalStateException("with a stack trace"));
        shapes.put("an object of a remote one's (JRMP)", new ObjID());
        shapes.put("an object in an object (RMI)", new MarshalledObject<>(new Gadget()));
        shapes.put("a list of listeners", new EventListenerList());
        shapes.put("a class", Runtime.class);
        return shapes.entrySet().stream().map(shape -> Arguments.of(shape.getKey(), shape.getValue()));
    }

    private static Object proxy(Class<?> type) {
        return Proxy.newProxyInstance(HostileStreamsTest.class.getClassLoader(), new Class<?>[] {type}, new Gadget());
    }

    private static Serializable queue(Comparator<Object> order) {
        PriorityQueue<Object> queue = new PriorityQueue<>(order);
        queue.addAll(List.of("one", "other"));
        return queue;
    }

    private static Serializable tree(Comparator<Object> order) {
        TreeMap<Object, Object> tree = new TreeMap<>(order);
        tree.put("one", 1);
        return tree;
    }

    @BeforeEach
    void forget() {
        RAN.set(0);
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("gadgets")
    void inAnActsFieldIsRefusedWithoutRunning(String name, Serializable gadget) throws IOException {
        byte[] stream = Pocket.with(gadget);
        RAN.set(0);
        assertThatThrownBy(() -> ActFile.of("bad.act", stream))
                .isInstanceOf(ActException.class)
                .hasMessageStartingWith("bad.act holds ");
        assertThat(RAN).hasValue(0);
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("gadgets")
    void aloneIsNoAct(String name, Serializable gadget) throws IOException {
        byte[] stream = Pocket.stream(gadget);
        RAN.set(0);
        assertThatThrownBy(() -> ActFile.of("bad.act", stream)).isInstanceOf(ActException.class);
        assertThat(RAN).hasValue(0);
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("gadgets")
    void inAFileWithCodeIsRefusedWithoutRunningEvenAfterConsent(String name, Serializable gadget) throws IOException {
        Map<String, byte[]> entries = new TreeMap<>();
        entries.put(
                ActManifest.PATH,
                "Manifest-Version: 1.0\nAct-Format: 1\nAct-Class: majic.act.Pocket\n".getBytes(StandardCharsets.UTF_8));
        entries.put(ActContents.DATA, Pocket.with(gadget));
        entries.put("Code.class", TinyClass.of("Code", 61));
        RAN.set(0);
        ActFile file = ActFile.of("bad.act", BoundedZipTest.zip(entries));
        assertThatThrownBy(() -> file.load(Sources.trusting(file)))
                .isInstanceOf(ActException.class)
                .hasMessageStartingWith("bad.act holds ");
        assertThat(RAN).hasValue(0);
    }

    static Stream<Arguments> bombs() {
        return Stream.of(
                Arguments.of("sets in sets (SerialDOS)", setsInSets(100), "deep"),
                Arguments.of("fewer sets in sets", setsInSets(15), "deep"),
                Arguments.of("lists in lists", nested(200), "deep"),
                Arguments.of("a long array", new byte[ActObjectInput.MAX_ARRAY + 1], "65537 elements"),
                Arguments.of("many objects", manyObjects(), "objects"),
                Arguments.of("a long text", "long ".repeat(1 << 18), "bytes"),
                Arguments.of("a list that is in itself", cyclic(), "holds itself"));
    }

    /**
     * Every set has two sets, and both sets of a level have the same two; to hash the first takes 2 to the power of
     * levels.
     */
    private static Serializable setsInSets(int levels) {
        HashSet<Object> root = new HashSet<>();
        HashSet<Object> one = root;
        HashSet<Object> other = new HashSet<>();
        for (int i = 0; i < levels; i++) {
            HashSet<Object> below = new HashSet<>(Set.of("unlike the other"));
            HashSet<Object> beside = new HashSet<>();
            one.addAll(List.of(below, beside));
            other.addAll(List.of(below, beside));
            one = below;
            other = beside;
        }
        return root;
    }

    private static Serializable nested(int levels) {
        ArrayList<Object> root = new ArrayList<>();
        for (int i = 0; i < levels; i++) {
            root = new ArrayList<>(List.of(root));
        }
        return root;
    }

    private static Serializable manyObjects() {
        return new ArrayList<>(
                IntStream.range(0, 20_000).mapToObj(i -> new int[0]).toList());
    }

    private static Serializable cyclic() {
        ArrayList<Object> list = new ArrayList<>();
        list.add(list);
        return list;
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("bombs")
    void whatGrowsBeyondAllBoundsIsRefused(String name, Serializable bomb, String why) throws IOException {
        byte[] stream = Pocket.with(bomb);
        assertThatThrownBy(() -> ActFile.of("bad.act", stream))
                .isInstanceOf(ActException.class)
                .hasMessageContaining(why);
    }

    /** Sets of the greatest depth, all of whose sets are shared: the worst case within the limits. */
    private static Serializable sharedSets(Object[] values, int sets) {
        List<Object> inner = new ArrayList<>();
        for (int i = 0; i < sets; i++) {
            inner.add(new HashSet<>(Arrays.asList(values).subList(i, values.length)));
        }
        List<Object> middle = new ArrayList<>();
        for (int i = 0; i < sets; i++) {
            middle.add(new HashSet<>(inner.subList(i, sets)));
        }
        return new HashSet<>(middle);
    }

    @Test
    void withinTheLimitsSharedSetsTakeLittleTime() throws IOException {
        Object[] values = IntStream.range(0, 20).mapToObj(String::valueOf).toArray();
        ActFile file = ActFile.of("pocket.act", Pocket.with(sharedSets(values, 20)));
        assertThat(file.carriesCode()).isFalse();
    }

    @Test
    void anArrayThatOnlyClaimsToBeLongTakesNoMemory() throws IOException {
        byte[] stream = Pocket.with(new int[] {0x5EED5EED});
        int length = ByteBuffer.wrap(stream).getInt(stream.length - 8);
        ByteBuffer.wrap(stream).putInt(stream.length - 8, Integer.MAX_VALUE);
        assertThat(length).isOne();
        assertThatThrownBy(() -> ActFile.of("bad.act", stream)).hasMessageContaining("an array of 2147483647");
    }

    @Test
    void onlyOneActIsInAStream() throws IOException {
        byte[] act = Pocket.with(1);
        byte[] two =
                ByteBuffer.allocate(act.length + 1).put(act).put((byte) 0x70).array();
        assertThatThrownBy(() -> ActFile.of("bad.act", two)).hasMessage("bad.act has data behind its act");
    }

    @Test
    void whereverAStreamEndsTooEarlyThatIsSaid() throws IOException {
        byte[] act = Pocket.with(new ArrayList<>(List.of("one", 2, new double[] {3})));
        for (int length = 0; length < act.length; length++) {
            byte[] part = Arrays.copyOf(act, length);
            assertThatThrownBy(() -> ActFile.of("bad.act", part))
                    .isInstanceOf(ActException.class)
                    .hasMessageContaining("cut off");
        }
    }

    @Test
    void anyOtherByteAnywhereIsReadOrRefusedButNothingElse() throws IOException {
        byte[] act = Pocket.with(new ArrayList<>(List.of("one", 2, new double[] {3}, new HashMap<>(Map.of("a", 'b')))));
        ActTrust trust = new ActTrust(Settings.inMemory());
        Random random = new Random(6);
        for (int at = 0; at < act.length; at++) {
            byte[] other = act.clone();
            other[at] ^= (byte) (1 + random.nextInt(255));
            assertThat(catchThrowable(() -> ActFile.of("bad.act", other).load(trust)))
                    .satisfiesAnyOf(
                            none -> assertThat(none).isNull(),
                            one -> assertThat(one).isInstanceOf(ActException.class));
        }
    }
}
