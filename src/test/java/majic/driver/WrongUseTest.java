package majic.driver;

import static org.assertj.core.api.Assertions.assertThatNullPointerException;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import majic.bot.BotAddress;
import majic.bot.BotException;
import majic.bot.FakeBot;
import majic.bot.Guard;
import majic.bot.Unit;
import majic.bot.Value;
import majic.environment.BotEnvironment;
import majic.hemisson.MajicHemisson;
import majic.pioneer.MajicPioneer;
import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

/** Tests the messages for programs that use a robot wrongly. */
class WrongUseTest {
    @AutoClose
    private final SteppedBot stepped = new SteppedBot();

    private final FakeBot bot = stepped.bot;

    @Test
    void anArgumentThatIsNullIsNamed() {
        Map<String, ThrowingCallable> calls = new TreeMap<>();
        calls.put("until", () -> bot.move(100, (Guard) null));
        calls.put("parameter", () -> bot.get(null));
        calls.put("word", () -> bot.set("posture", (String) null));
        calls.put("values", () -> bot.set("posture", (List<Value>) null));
        calls.put("value", () -> bot.set("posture", Arrays.asList((Value) null)));
        calls.put("command", () -> bot.run(null, List.of()));
        calls.put("arguments", () -> bot.run("wag", null));
        calls.put("pose", () -> bot.place(null));
        calls.put("listener", () -> bot.addListener(null));
        calls.put("watcher", () -> bot.addWatcher(null));
        calls.put("address", () -> BotAddress.parse(null));

        calls.forEach((name, call) ->
                assertThatNullPointerException().isThrownBy(call).withMessage(name));
    }

    @Test
    void aRobotThatIsConnectedCannotBeConnectedAgain() {
        assertThatThrownBy(bot::connect).isInstanceOf(BotException.class).hasMessage("the Fake is already connected");
    }

    @Test
    void aClosedRobotSaysThatItIsClosed() {
        bot.close();

        for (ThrowingCallable call : List.<ThrowingCallable>of(
                bot::connect,
                () -> bot.move(100),
                () -> bot.drive(100, 0),
                () -> bot.drive(100, 0, 1, Guard.NEVER),
                () -> bot.run("wag", List.of(Value.of(1, Unit.NONE))),
                () -> bot.set("posture", "sit"))) {
            assertThatThrownBy(call).isInstanceOf(BotException.class).hasMessage("the Fake is closed");
        }
    }

    @Test
    void aRobotIsNotMadeFromTheAddressOfAnother() {
        assertThatThrownBy(() -> new MajicPioneer("aibo://10.0.0.5"))
                .isInstanceOf(BotException.class)
                .hasMessageStartingWith("aibo://10.0.0.5: not a Pioneer's address; it looks like pioneer://");
        assertThatThrownBy(() -> new MajicPioneer("sim:pioneer"))
                .isInstanceOf(BotException.class)
                .hasMessageStartingWith("sim:pioneer: not a Pioneer's address");
        assertThatThrownBy(() -> new MajicHemisson(BotAddress.parse("pioneer:COM3"), BotEnvironment.plain()))
                .isInstanceOf(BotException.class)
                .hasMessageStartingWith("pioneer:COM3: not a Hemisson's address; it looks like hemisson:COM3");
    }
}
