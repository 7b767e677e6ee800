package majicsim.pioneer.devices;

import static org.assertj.core.api.Assertions.assertThat;

import majicsim.pioneer.Rig;
import majicsim.pioneer.SipView;
import org.junit.jupiter.api.Test;

/** Battery, BATTEST, LOWBATTERY, charger (ARCOS sheet 6.1, 8). */
class BatteryTest {
    private static final int BATTEST = 250;
    private static final int CHARGE = 68;
    private static final int POWER_GOOD = 1 << 10;

    private final Rig rig = Rig.open(Rig.EQUIPPED);

    @Test
    void itFallsSlowlyWithUse() {
        Battery battery = new Battery();
        assertThat(battery.tenthVolts()).isEqualTo(130);
        for (int minutes = 0; minutes < 5 * 60; minutes++) {
            battery.step(60, 2);
        }
        assertThat(battery.tenthVolts()).isEqualTo(121);
        assertThat(battery.percent()).isEqualTo(54);
    }

    @Test
    void drivingDrawsMoreThanStanding() {
        Rig driving = Rig.ready().command(21, 30).command(6, 2200).command(5, 2000);
        for (int i = 0; i < 60; i++) {
            driving.command(11, i % 2 == 0 ? 800 : -800).pulse(1);
            rig.pulse(1);
        }
        assertThat(charge(driving)).isLessThan(charge(rig));
        assertThat(charge(rig)).isLessThan(1);
    }

    @Test
    void aPretendedVoltageStaysUntilTheRealOneIsRequestedAgain() {
        rig.command(BATTEST, 117).command(2, 1).reconnect().shakeHands();
        SipView sip = rig.nextSip();
        assertThat(sip.battery()).isEqualTo(117);
        assertThat(sip.chargePercent()).isEqualTo(35);
        assertThat(rig.command(BATTEST, 0).nextSip().battery()).isEqualTo(130);
    }

    @Test
    void belowLowBatteryItBeepsEveryFiveSeconds() {
        rig.command(BATTEST, 114).pulse(12);
        assertThat(rig.robot.handling().played()).hasSize(3).allMatch(tone -> tone.durationMs() == 200);
    }

    @Test
    void powerAtTheContactsChargesAndShows() {
        assertThat(rig.nextSip().chargeState()).isZero();
        rig.robot.handling().plugCharger(true);
        SipView sip = rig.nextSip();
        assertThat(sip.flags() & POWER_GOOD).isEqualTo(POWER_GOOD);
        assertThat(sip.chargeState()).isEqualTo(Charger.FLOAT);
    }

    @Test
    void chargeTakesTheMechanismBackAndPutsItOutAgain() {
        rig.robot.handling().plugCharger(true);
        assertThat(rig.command(CHARGE, 0).nextSip().flags() & POWER_GOOD).isZero();
        assertThat(rig.command(CHARGE, 1).nextSip().flags() & POWER_GOOD).isEqualTo(POWER_GOOD);
    }

    @Test
    void anEmptyBatteryIsChargedInThreeStages() {
        Battery battery = new Battery();
        Charger charger = new Charger(true, battery);
        battery.step(1, 21.6 * 3600 / 2);
        charger.power(true);
        assertThat(charger.state()).isEqualTo(Charger.BULK);
        charge(battery, charger, 90);
        assertThat(charger.state()).isEqualTo(Charger.OVERCHARGE);
        charge(battery, charger, 120);
        assertThat(charger.state()).isEqualTo(Charger.FLOAT);
    }

    @Test
    void aModelWithoutDockingMechanismDoesNotReportThePlug() {
        Rig bare = Rig.open();
        bare.robot.handling().plugCharger(true);
        SipView sip = bare.nextSip();
        assertThat(sip.chargeState()).isZero();
        assertThat(sip.flags() & POWER_GOOD).isZero();
    }

    @Test
    void batteriesThatReportThemselvesAreListed() {
        assertThat(rig.command(62, 1).packets(0xFA, 0.1).get(0)).startsWith(0xFA, 0xFB, 5, 0xFA, 0, 5);
        byte[] smart = Rig.open("pioneer-lx").command(62, 1).packets(0xFA, 0.1).get(0);
        assertThat(smart).startsWith(0xFA, 0xFB, 10, 0xFA, 1, 5, 0, 0, 0, 100, 100);
    }

    private static double charge(Rig rig) {
        return rig.robot.board().devices().battery().charge();
    }

    private static void charge(Battery battery, Charger charger, int minutes) {
        for (int minute = 0; minute < minutes; minute++) {
            battery.step(60, -charger.amperes());
        }
    }
}
