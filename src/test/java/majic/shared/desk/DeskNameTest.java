package majic.shared.desk;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.Set;
import majic.bot.BotException;
import majic.shared.broker.BrokerMessage;
import majic.shared.broker.FakeConnection;
import majic.shared.broker.Quality;
import majic.shared.message.Presence;
import majic.shared.message.Presence.State;
import majic.shared.message.Sender;
import majic.team.Team;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;

/** Tests that a desk name stands for one desk, and what others see when a desk begins and ends. */
class DeskNameTest {
    private static final String TOPIC = "lab/majic/1/desks/desk2/presence";

    @AutoClose
    private final SharingRig rig = SharingRig.started();

    @AutoClose
    private final Team other = new Team(rig.clock.time());

    private Presence kept() {
        return Presence.parse(rig.broker.retained(TOPIC).orElseThrow().payload());
    }

    private void present(State state, String session) {
        Presence presence = new Presence(state, new Sender("desk2", "Eve", session), "other", List.of());
        rig.broker.publish(BrokerMessage.json(TOPIC, presence.toJson(), Quality.AT_LEAST_ONCE)
                .retain());
    }

    @Test
    void aDeskIsOnlineWithItsRobotsAndOfflineAfterwards() {
        assertThat(kept().state()).isEqualTo(State.ONLINE);
        assertThat(kept().robots()).containsExactly(1);
        assertThat(kept().program()).isEqualTo("MAJIC test");

        rig.sharing.close();

        assertThat(kept().state()).isEqualTo(State.OFFLINE);
        assertThat(rig.broker.allRetained("lab/majic/1/desks/desk2/robots/#")).isEmpty();
    }

    @Test
    void aDeskThatCrashesIsBrokenByItsLastWill() {
        rig.clock.until(() -> rig.broker
                .retained("lab/majic/1/desks/desk2/robots/1/description")
                .isPresent());
        rig.connection().kill();

        assertThat(kept().state()).isEqualTo(State.BROKEN);
        assertThat(rig.broker.retained("lab/majic/1/desks/desk2/robots/1/description"))
                .isPresent();
    }

    @Test
    void aNameThatIsTakenIsRefusedAfterThreeSecondsAndNothingIsChanged() {
        long begin = rig.clock.time().nanos();

        assertThatThrownBy(() -> rig.sharing("desk2", other).start())
                .isInstanceOf(BotException.class)
                .hasMessage(
                        "desk2: another program shares robots under this name (Bob at desk2); choose another one with"
                                + " --desk");

        assertThat(rig.clock.time().secondsSince(begin)).isBetween(3.0, 3.5);
        assertThat(kept().state()).isEqualTo(State.ONLINE);
        assertThat(kept().sender()).isEqualTo(rig.sharing.self());
        assertThat(rig.sharing.isConnected()).isTrue();
    }

    @Test
    void aNameIsFreeAgainWhenTheWillOfItsDeskArrives() {
        FakeConnection cable = rig.connection();
        cable.cut();
        try (DeskSharing next = rig.sharing("desk2", other)) {
            next.start();

            assertThat(kept().sender()).isEqualTo(next.self());
        }
    }

    @Test
    void ofTwoDesksThatBeginAtOnceTheOneWithTheHigherSessionWithdraws() {
        present(State.ONLINE, "-");

        rig.clock.until(() -> !rig.sharing.problem().isEmpty());

        rig.clock.until(() -> rig.isSaid("sharing has ended: desk2: another program shares robots under this name"));
        assertThat(kept().sender().session()).isEqualTo("-");
        assertThat(rig.sharing.isConnected()).isFalse();
    }

    @Test
    void theOneWithTheLowerSessionKeepsTheNameAndSaysSo() {
        present(State.ONLINE, "z");

        rig.clock.until(() -> kept().sender().equals(rig.sharing.self()));
        assertThat(rig.sharing.isConnected()).isTrue();
    }

    @Test
    void theLastWillOfAnotherProgramDoesNotHideTheDesk() {
        present(State.BROKEN, "a");

        rig.clock.until(() -> kept().sender().equals(rig.sharing.self()));
        assertThat(kept().state()).isEqualTo(State.ONLINE);
    }

    @Test
    void robotsOfAnEarlierRunThatAreNotSharedAnyMoreAreRemoved() {
        rig.sharing.close();
        String old = "lab/majic/1/desks/desk4/robots/7/description";
        rig.broker.publish(BrokerMessage.json(old, "{}", Quality.AT_LEAST_ONCE).retain());
        try (DeskSharing next = rig.sharing("desk4", other)) {
            next.start();
            rig.clock.until(() -> rig.broker.retained(old).isEmpty());
        }
    }

    @Test
    void aNameThatCannotBeOneIsRefusedBeforeAnythingIsConnected() {
        assertThatThrownBy(() -> new DeskOptions("lab", "desk/2", "Bob", "", Set.of(), false))
                .hasMessage(
                        "desk/2: the name of a desk is a letter, then letters, digits, - and _, at most 20 characters"
                                + " in all");
    }
}
