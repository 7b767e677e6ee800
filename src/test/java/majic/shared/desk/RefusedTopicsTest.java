package majic.shared.desk;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Set;
import majic.bot.BotException;
import majic.shared.broker.FakeConnection;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests what a desk says that shares robots as a user of the broker who may not publish everything. */
class RefusedTopicsTest {
    private static final String DESK = "lab/majic/1/desks/desk2/";

    @AutoClose
    private final SharingRig rig = new SharingRig();

    @ParameterizedTest
    @CsvSource({"presence, desks/desk3/presence", "answers, replies/+"})
    void aDeskThatMayNotShareSaysSoAndSharesNothing(String what, String filter) {
        rig.add();
        DeskSharing sharing = new DeskSharing(
                rig.team, new DeskOptions("lab", "desk3", "Bob", "MAJIC test", Set.of(), false), (id, will) -> {
                    FakeConnection connection = rig.open(id, will);
                    connection.refuse("lab/majic/1/" + filter);
                    return connection;
                });

        assertThatThrownBy(sharing::start)
                .as(what)
                .isInstanceOf(BotException.class)
                .hasMessageStartingWith("no robot is shared: the broker did not take the message on lab/majic/1/")
                .hasMessageContaining(": not authorized; ")
                .hasMessageEndingWith("may write lab/majic/1/desks/desk3/# and lab/majic/1/replies/#");
        assertThat(sharing.isConnected()).isFalse();
        assertThat(rig.broker.allRetained("lab/majic/1/desks/desk3/#")).isEmpty();
    }

    @ParameterizedTest
    @CsvSource({
        "description, other desks do not see robot 1",
        "state, other desks receive no readings of robot 1 and cannot use it",
        "messages, other desks receive no messages of robot 1"
    })
    void whatTheBrokerRefusesOfARobotIsSaidOnce(String part, String meaning) {
        rig.add();
        rig.connection().refuse(DESK + "robots/+/" + part);
        rig.sharing.start();
        rig.team.member(1).notice("battery low");
        rig.clock.until(
                () -> rig.isSaid("the broker refuses " + DESK + "robots/1/" + part + " (not authorized): " + meaning));
        rig.sleep(5);

        assertThat(rig.said.stream().filter(line -> line.startsWith("the broker refuses")))
                .hasSize(1);
    }

    @Test
    void aMalformedMessageOnTheTopicForStopsStopsTheRobotAndIsNamed() {
        rig.add();
        rig.sharing.start();
        rig.broker.publishMalformed(DESK + "robots/1/stop", "its response topic is empty");

        rig.clock.until(() -> rig.bot().sent().contains("halt"));
        rig.clock.until(() ->
                rig.isSaid("a message on " + DESK + "robots/1/stop is left out: its response topic is" + " empty"));
    }

    @Test
    void descriptionAndPresenceArePublishedAgainBeforeTheyExpire() {
        rig.add();
        rig.sharing.start();
        rig.clock.until(() -> rig.broker.retained(DESK + "robots/1/description").isPresent());
        rig.sleep(1.5 * DeskPresence.RENEWAL_S);
        assertThat(rig.broker.published(DESK + "robots/1/description")).hasSize(2);
        rig.sleep(2 * DeskPresence.RENEWAL_S);

        assertThat(rig.broker.retained(DESK + "robots/1/description")).isPresent();
        assertThat(rig.broker.retained(DESK + "presence")).isPresent();
        rig.connection().kill();
        rig.sleep(DeskPresence.EXPIRY_S + 1);
        assertThat(rig.broker.allRetained(DESK + "#")).isEmpty();
    }
}
