package majic.gui.add;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.awt.Component;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JTextField;
import javax.swing.SwingUtilities;
import javax.swing.event.ListDataEvent;
import javax.swing.event.ListDataListener;
import majic.bot.BotAddress;
import majic.bot.BotException;
import majic.environment.BotEnvironment;
import majic.environment.Settings;
import majic.shared.SharedType;
import majic.shared.broker.BrokerMessage;
import majic.shared.broker.ConnectOptions;
import majic.shared.broker.FakeBroker;
import majic.shared.broker.Quality;
import majic.shared.message.Presence;
import majic.shared.message.Sender;
import majic.team.BotFactory;
import majic.time.TimeSource;
import majic.time.WaitLimit;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Tests the fields for a robot of another desk. */
class SiteInputTest {
    @AutoClose
    private final FakeBroker broker = new FakeBroker(TimeSource.system());

    private final SharedType type = new SharedType((address, options) -> broker.open(
            ConnectOptions.of(options.clientId(), new BotEnvironment(TimeSource.system(), Settings.inMemory()))));
    private SiteInput input;

    @BeforeEach
    void makeFields() throws Exception {
        SwingUtilities.invokeAndWait(
                () -> input = new SiteInput(type, new BotFactory(List.of(type), Settings.inMemory())));
    }

    private <T> T field(String name, Class<T> kind) {
        for (Component child : input.getComponents()) {
            if (name.equals(child.getName())) {
                return kind.cast(child);
            }
        }
        throw new AssertionError("no " + name);
    }

    private boolean fill(String address) {
        return input.fill(BotAddress.parse(address));
    }

    @Test
    void anAddressIsTakenApartAndPutTogetherAgain() {
        for (String address : List.of(
                "mqtt://broker:1883/lab/desk2/1", "mqtts://10.0.0.5:8883/school/lab/desk2/12", "mqtt://b:9/l/d/3")) {
            assertThat(fill(address)).isTrue();
            assertThat(input.address()).isEqualTo(address);
        }
        assertThat(fill("pioneer://10.0.0.5:8101")).isFalse();
    }

    @Test
    void missingFieldsAreNamed() {
        assertThat(fill("mqtt://broker/lab/")).isTrue();
        assertThatThrownBy(input::address).isInstanceOf(BotException.class).hasMessageContaining("such as desk2/1");
        field("site", JTextField.class).setText("");
        field("siteRobot", JComboBox.class).getEditor().setItem("desk2/1");
        assertThatThrownBy(input::address).hasMessageContaining("the site, such as lab");
    }

    @Test
    void aSiteWithoutRobotsIsReported() throws Exception {
        CompletableFuture<String> problem = new CompletableFuture<>();
        SwingUtilities.invokeAndWait(() -> {
            input.addPropertyChangeListener(
                    AddressInput.PROBLEM, event -> problem.complete(String.valueOf(event.getNewValue())));
            fill("mqtt://broker/lab/");
            field("listRobots", JButton.class).doClick();
        });

        assertThat(WaitLimit.join("the problem", problem))
                .isEqualTo("No desk shares a robot at mqtt://broker:1883/lab/");
    }

    @Test
    void theRobotsOfTheSiteAreOffered() throws Exception {
        BrokerMessage description = BrokerMessage.json(
                        "lab/majic/1/desks/desk2/robots/1/description",
                        "{\"session\":\"s\",\"type\":\"aibo\",\"make\":\"Sony Aibo ERS-7\",\"profile\":{\"bodyMm\":200,"
                                + "\"speed\":{\"min\":-1,\"max\":1},\"turn\":{\"min\":-1,\"max\":1},\"cruiseMmPerSec\":1,"
                                + "\"cruiseTurnDegPerSec\":1,\"nearMm\":1}}",
                        Quality.AT_LEAST_ONCE)
                .retain();
        Presence presence = new Presence(Presence.State.ONLINE, new Sender("desk2", "Bert", "s"), "MAJIC", List.of(1));
        broker.publish(BrokerMessage.json("lab/majic/1/desks/desk2/presence", presence.toJson(), Quality.AT_LEAST_ONCE)
                .retain());
        broker.publish(description);
        CompletableFuture<Map.Entry<String, String>> offered = new CompletableFuture<>();
        SwingUtilities.invokeAndWait(() -> {
            fill("mqtt://broker/lab/");
            JComboBox<?> robot = field("siteRobot", JComboBox.class);
            robot.getModel()
                    .addListDataListener(new Offers(() -> SwingUtilities.invokeLater(
                            () -> offered.complete(Map.entry(String.valueOf(robot.getItemAt(0)), input.address())))));
            JButton list = field("listRobots", JButton.class);
            // A busy computer may need longer than the time for which robots are listed.
            input.addPropertyChangeListener(AddressInput.PROBLEM, event -> list.doClick());
            list.doClick();
        });

        assertThat(WaitLimit.join("the robots", offered))
                .isEqualTo(Map.entry("desk2/1 (Sony Aibo ERS-7)", "mqtt://broker:1883/lab/desk2/1"));
    }

    /** Learns of the first entry. */
    private record Offers(Runnable whenAdded) implements ListDataListener {
        @Override
        public void intervalAdded(ListDataEvent event) {
            whenAdded.run();
        }

        @Override
        public void intervalRemoved(ListDataEvent event) {}

        @Override
        public void contentsChanged(ListDataEvent event) {}
    }
}
