package majicsim.aibo;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

/** Classes and their objects (URBI sheet, section 10; capture F). */
class ObjectTest {
    private final Bench bench = Bench.exact();
    private final Bench.Client client = bench.client();

    @Test
    void anObjectHasTheFunctionsOfItsClass() {
        assertThat(client.ask("class C { var v; function k(); }; function C.k() { return 3 }; c = new C; c.k();"))
                .containsExactly("[notag] 3.000000");
    }

    @Test
    void eachObjectHasItsOwnFields() {
        client.say("class C { var v }; C.v = 1; function C.set(x) { self.v = x }; a = new C; b = new C; a.set(5);");

        assertThat(client.ask("a.v; b.v; C.v; a;"))
                .containsExactly(
                        "[notag] 5.000000", "[notag] 1.000000", "[notag] 1.000000", "[notag] OBJ [v:5.000000]");
    }

    @Test
    void theConstructorTakesTheArguments() {
        client.say("class C; function C.init(x) { self.v = x; return 0 }; c = new C(4);");

        assertThat(client.ask("c.v;")).containsExactly("[notag] 4.000000");
    }

    @Test
    void aConstructorThatFailsLeavesNoObject() {
        client.say("class C; function C.init() { return 1 }; function C.k() { 2 };");

        assertThat(client.ask("c = new C(); c.k();"))
                .containsExactly(
                        "[notag] *** Error: Constructor failed, objet deleted",
                        "[notag] !!! Error with function eval: c.k [no param]",
                        "[notag] !!! EXPR evaluation failed");
    }

    @Test
    void anUnknownClassIsAnError() {
        assertThat(client.ask("c = new Nothing;")).containsExactly("[notag] !!! Unkown object Nothing");
        assertThat(client.ask("class C; c = new C; c = new C;"))
                .containsExactly("[notag] !!! c has already inherited from C");
    }
}
