package majic.shared.desk;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Set;
import majic.environment.BotEnvironment;
import majic.environment.Settings;
import majic.inlab.LabRig;
import majic.shared.broker.BrokerMessage;
import majic.shared.broker.ConnectOptions;
import majic.shared.broker.FakeBroker;
import majic.time.TimeSource;
import org.junit.jupiter.api.Test;

/** Tests how much a desk publishes of a Pioneer that reports ten times a second. */
class StateTrafficInLabTest {
    private static final String ROBOT = "lab/majic/1/desks/desk2/robots/1/";
    private static final double SETTLED_S = 3;
    private static final int MEASURED_S = 10;

    /** What was published within ten seconds. */
    private record Traffic(List<BrokerMessage> states, List<BrokerMessage> changes) {
        int bytesPerSecond() {
            return (bytes(states) + bytes(changes)) / MEASURED_S;
        }

        private static int bytes(List<BrokerMessage> messages) {
            return messages.stream()
                    .mapToInt(message -> message.payload().length)
                    .sum();
        }
    }

    /** Connects the Pioneer of a lab, shares it, and collects what is published while it is stationary. */
    private static Traffic ofStationaryPioneer(LabRig rig) throws InterruptedException {
        TimeSource time = rig.team().time();
        rig.add("pioneer");
        FakeBroker broker = new FakeBroker(time);
        DeskOptions options = new DeskOptions("lab", "desk2", "Bob", "MAJIC test", Set.of(), false);
        try (DeskSharing sharing = new DeskSharing(
                rig.team(),
                options,
                (client, will) -> broker.open(new ConnectOptions(
                        client, will, 1, ConnectOptions.TIMEOUT_MS, new BotEnvironment(time, Settings.inMemory()))))) {
            sharing.start();
            time.sleep(SETTLED_S);
            int states = broker.published(ROBOT + "state").size();
            int changes = broker.published(ROBOT + "changes").size();
            time.sleep(MEASURED_S);
            return new Traffic(
                    after(states, broker.published(ROBOT + "state")),
                    after(changes, broker.published(ROBOT + "changes")));
        }
    }

    private static List<BrokerMessage> after(int count, List<BrokerMessage> all) {
        return all.subList(count, all.size());
    }

    @Test
    void readingsWithNoiseCostAFifthOfWholeStates() throws InterruptedException {
        try (LabRig rig = LabRig.noisy(1)) {
            Traffic traffic = ofStationaryPioneer(rig);

            assertThat(traffic.states()).hasSizeBetween(9, 11);
            assertThat(traffic.changes()).hasSizeBetween(80, 95);
            int wholeEachTime = 10 * traffic.states().get(0).payload().length;
            assertThat(traffic.bytesPerSecond()).isLessThan(wholeEachTime / 5);
        }
    }

    @Test
    void readingsThatRemainTheSameCostTheStatesAlone() throws InterruptedException {
        try (LabRig rig = LabRig.exact()) {
            Traffic traffic = ofStationaryPioneer(rig);

            assertThat(traffic.states()).hasSizeBetween(9, 11);
            assertThat(traffic.changes()).isEmpty();
        }
    }
}
