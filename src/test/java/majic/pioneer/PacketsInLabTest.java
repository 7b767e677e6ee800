package majic.pioneer;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Objects;
import majic.inlab.LabRig;
import majic.pioneer.arcos.Batteries;
import majic.pioneer.arcos.ReportKind;
import majic.pioneer.session.PioneerSession;
import majic.pioneer.state.EncoderTicks;
import majic.pioneer.state.PioneerState;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** The reports of the lab's Pioneer as the driver decodes them. */
class PacketsInLabTest {
    @AutoClose
    private LabRig rig;

    private MajicPioneer bot;

    @BeforeEach
    void connect() {
        rig = LabRig.exact();
        bot = (MajicPioneer) rig.add("pioneer");
    }

    @Test
    void portsAndBatteriesComeByThemselvesAfterConnecting() throws InterruptedException {
        rig.await(() -> state().reports().latest(Batteries.class).isPresent());

        assertThat(state().ports().allDigitalIn()).isNotEmpty();
        assertThat(state().ports().allAnalogVolts()).isNotEmpty();
    }

    @Test
    void encodersAreStreamedWhenReadAndCountTheDistance() {
        assertThat(state().encoders()).isEmpty();

        EncoderTicks before = encoders();
        bot.move(500);
        EncoderTicks after = encoders();

        assertThat(after.left()).isGreaterThan(before.left());
        assertThat(after.right() - before.right()).isEqualTo(after.left() - before.left());
    }

    private EncoderTicks encoders() {
        session().subscriptions().read(ReportKind.ENCODERS);
        assertThat(session().await(state -> state.encoders().isPresent(), 2)).isTrue();
        return state().encoders().orElseThrow();
    }

    private PioneerState state() {
        return session().state();
    }

    private PioneerSession session() {
        return Objects.requireNonNull(bot.session());
    }
}
