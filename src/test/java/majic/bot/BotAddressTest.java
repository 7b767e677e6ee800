package majic.bot;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import majic.environment.Settings;
import majic.team.BotFactory;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class BotAddressTest {
    @Test
    void anAddressMayNameALibraryBehindThePlusSign() {
        BotAddress address = BotAddress.parse("Pioneer+Aria://10.0.0.5:8101");

        assertThat(address.type()).isEqualTo("pioneer");
        assertThat(address.library()).contains("aria");
        assertThat(address.rest()).isEqualTo("//10.0.0.5:8101");
        assertThat(address).hasToString("pioneer+aria://10.0.0.5:8101");
    }

    @Test
    void anAddressWithoutOneMeansTheProgramsOwnClient() {
        BotAddress address = BotAddress.parse("hemisson:COM3");

        assertThat(address.type()).isEqualTo("hemisson");
        assertThat(address.library()).isEmpty();
    }

    @Test
    void aLibraryThatATypeDoesNotUseIsRefusedWithThoseThatItDoes() {
        BotType type = new FakeType() {
            @Override
            public List<String> libraries() {
                return List.of("one", "two");
            }
        };
        BotFactory factory = new BotFactory(List.of(type), Settings.inMemory());
        assertThatThrownBy(() -> factory.create("fake+three://a"))
                .isInstanceOf(BotException.class)
                .hasMessage("fake+three://a: there is no library three for it; it looks like fake://a or"
                        + " fake+one://a or fake+two://a");
        assertThat(factory.create("fake+two://a").type()).isEqualTo(type);
    }

    @ParameterizedTest
    @ValueSource(strings = {"10.0.0.5:8101", "robot.example:8101", "pioneer", ":8101", "pioneer:", "/dev/ttyS0:1"})
    void anAddressWithoutTheTypeOfTheRobotIsRefusedWithOneThatHasIt(String typed) {
        assertThatThrownBy(() -> BotAddress.parse(typed))
                .isInstanceOf(BotException.class)
                .hasMessage(typed
                        + ": not a robot's address; it looks like pioneer://10.0.0.5:8101, hemisson:COM3 or sim:aibo");
    }

    @Test
    void aRobotThatIsReachedThroughABrokerIsOfAnotherDesk() {
        assertThat(BotAddress.parse("pioneer://10.0.0.5").isOfAnotherDesk()).isFalse();
        assertThat(BotAddress.parse("mqtt://broker/lab/desk2/1").isOfAnotherDesk())
                .isTrue();
        assertThat(BotAddress.parse("mqtts://broker/lab/desk2/1").isOfAnotherDesk())
                .isTrue();
    }
}
