package majic.gui.add;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import javax.swing.JTextField;
import majic.bot.BotAddress;
import majic.bot.BotException;
import majic.bot.BotType;
import majic.gui.ToyType;
import majic.ros.RosType;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class AddressInputTest {
    private final NetworkInput input = new NetworkInput(new ToyType(BotType.Reach.TCP));

    @Test
    void hostAndPortMakeAnAddress() {
        fill("10.0.0.5", "8101");
        assertThat(input.address()).isEqualTo("toy://10.0.0.5:8101");
    }

    @Test
    void aSerialServerIsNamedAsOne() {
        NetworkInput server = new NetworkInput(new ToyType(BotType.Reach.SERIAL, BotType.Reach.TCP));
        field(server, "host").setText("gateway");
        assertThat(server.address()).isEqualTo("toy:tcp://gateway:4242");
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "0", "65536", "-1", "eight", "999999999999"})
    void aPortThatIsNoneIsRefused(String port) {
        fill("host", port);
        assertThatThrownBy(input::address).isInstanceOf(BotException.class).hasMessageStartingWith("Port: ");
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "  ", "two words", "http://robot"})
    void aHostThatIsNoneIsRefused(String host) {
        fill(host, "1");
        assertThatThrownBy(input::address).isInstanceOf(BotException.class).hasMessageStartingWith("Host: ");
    }

    @Test
    void aTypeWithSeveralRobotsBehindAPortIsAskedForTheNamespace() {
        NetworkInput ros = new NetworkInput(new RosType());
        field(ros, "host").setText("10.0.0.5");
        assertThat(ros.address()).isEqualTo("ros://10.0.0.5:9090");

        field(ros, "namespace").setText(" robot1 ");
        assertThat(ros.address()).isEqualTo("ros://10.0.0.5:9090/robot1");
        field(ros, "namespace").setText("two words");
        assertThatThrownBy(ros::address).isInstanceOf(BotException.class).hasMessageStartingWith("Namespace: ");
    }

    @Test
    void anAddressWithANamespaceFillsInAllFields() {
        NetworkInput ros = new NetworkInput(new RosType());

        assertThat(ros.fill(BotAddress.parse("ros://10.0.0.5/robot1?base=/odom")))
                .isTrue();
        assertThat(ros.address()).isEqualTo("ros://10.0.0.5:9090/robot1?base=/odom");
        assertThat(ros.fill(BotAddress.parse("ros://10.0.0.6"))).isTrue();
        assertThat(ros.address()).isEqualTo("ros://10.0.0.6:9090");
        assertThat(input.fill(BotAddress.parse("toy://10.0.0.5:8101/robot1"))).isFalse();
    }

    private void fill(String host, String port) {
        field(input, "host").setText(host);
        field(input, "port").setText(port);
    }

    private static JTextField field(NetworkInput input, String name) {
        for (var component : input.getComponents()) {
            if (component instanceof JTextField field && name.equals(field.getName())) {
                return field;
            }
        }
        throw new AssertionError("no field " + name);
    }
}
