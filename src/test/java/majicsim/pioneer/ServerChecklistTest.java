package majicsim.pioneer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.charset.StandardCharsets;
import java.util.List;
import majicsim.pioneer.model.PioneerModel;
import majicsim.pioneer.packet.Hex;
import majicsim.world.Noise;
import majicsim.world.Pose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The list of what a server owes the vendor's client and Player (ARCOS sheet 16), point by point. */
class ServerChecklistTest {
    private static final int OPEN = 1;
    private static final int CLOSE = 2;
    private static final int ENABLE = 4;
    private static final int MOVE = 8;
    private static final int VEL = 11;
    private static final int HEAD = 12;
    private static final int CONFIG = 18;
    private static final int RVEL = 21;
    private static final int SONAR = 28;

    @Test
    void echoesSync0And1ByteForByteAndAnswersSync2WithThreeStrings() {
        Rig rig = Rig.silent().command(0).command(1).command(2);
        List<byte[]> answers = rig.line.take();
        assertThat(answers.get(0)).isEqualTo(Hex.bytes("FA FB 03 00 00 00"));
        assertThat(answers.get(1)).isEqualTo(Hex.bytes("FA FB 03 01 00 01"));
        assertThat(text(answers.get(2))).matches("[^\0]+\0Pioneer\0p3dx-sh\0");
    }

    @ParameterizedTest
    @MethodSource("majicsim.pioneer.PioneerRobot#models")
    void namesASubclassThatTheVendorsClientSupports(String model) {
        Rig rig = rig(model).command(0).command(1).command(2);
        assertThat(text(rig.line.take().get(2))).endsWith("\0" + model + "\0");
    }

    @Test
    void saysNothingBeforeOpenAndThenASipEvery100MsEachInOneWrite() {
        Rig rig = Rig.silent().command(0).command(1).command(2);
        rig.line.take();
        assertThat(rig.step(1).line.take()).isEmpty();
        List<byte[]> writes = rig.command(OPEN).step(1).line.take();
        assertThat(writes).hasSize(10).allMatch(SipView::isSip);
        assertThat(writes).allMatch(write -> write.length == (write[2] & 0xFF) + 3);
    }

    @Test
    void answersConfigAtOnceAsASimulator() {
        Rig rig = Rig.open();
        rig.line.take();
        byte[] config = rig.command(CONFIG, 1).line.take().get(0);
        assertThat(text(config)).startsWith("Pioneer\0p3dx-sh\0SIM\0").contains("S.0");
    }

    @ParameterizedTest
    @MethodSource("majicsim.pioneer.PioneerRobot#models")
    void scalesPositionsByTheSubclass(String model) {
        Rig rig = rig(model)
                .shakeHands()
                .command(ENABLE, 1)
                .command(VEL, 200)
                .pulse(3)
                .command(VEL, 0)
                .pulse(2);
        double mmPerUnit = PioneerModel.of(model).scaling().mmPerPositionUnit();
        double mmPerSpeedUnit = PioneerModel.of(model).scaling().mmPerSecPerSpeedUnit();
        assertThat(rig.nextSip().x() * mmPerUnit).isCloseTo(rig.pose().xMm(), within(mmPerUnit));
        int left = rig.command(VEL, -150).step(1.5).nextSip().left();
        assertThat(left * mmPerSpeedUnit).isCloseTo(-150, within(mmPerSpeedUnit));
    }

    @Test
    void wrapsXAndYAtSixteenBits() {
        Rig rig =
                Rig.ready().packet(7, "3B 00 7F 00 81 00 00").command(VEL, 500).pulse(2);
        int before = rig.nextSip().x();
        rig.step(0.5);
        int after = rig.nextSip().x();
        assertThat(before).isNegative();
        assertThat((short) (after - before)).isBetween((short) 250, (short) 320);
    }

    @Test
    void motorsAreOffUntilEnableAndFlagsZeroToFourAreRight() {
        Rig rig = Rig.open();
        assertThat(rig.nextSip().flags()).isEqualTo(0x1E);
        assertThat(rig.command(ENABLE, 1).nextSip().flags()).isEqualTo(0x1F);
        assertThat(rig.command(SONAR, 0).nextSip().flags()).isEqualTo(0x01);
        assertThat(rig.command(ENABLE, 0).nextSip().flags()).isEqualTo(0x00);
        assertThat(rig.command(SONAR, 1).nextSip().flags()).isEqualTo(0x1E);
    }

    @Test
    void motionCommandsAreNotRememberedWhileMotorsAreOff() {
        Rig rig = Rig.open()
                .command(VEL, 300)
                .command(HEAD, 90)
                .command(ENABLE, 1)
                .pulse(1);
        assertThat(rig.pose()).isEqualTo(new Pose(0, 0, 0));
    }

    @Test
    void bothArgumentFormsWork() {
        Rig rig = Rig.silent().command(0).command(1).command(2).command(OPEN).command(ENABLE, 1);
        rig.line.take();
        assertThat(rig.command(CONFIG).command(CONFIG, 1).line.take()).hasSize(2);
        rig.send("FA FB 06 20 3B 0A FB 2B 36").step(1.2);
        SipView raw = rig.nextSip();
        rig.send("FA FB 06 20 1B F6 04 16 1F").step(0.2);
        assertThat(List.of(raw.left(), raw.right())).containsExactly(-100, 200);
        assertThat(List.of(rig.nextSip().left(), rig.nextSip().right())).containsExactly(-100, 200);
    }

    @Test
    void repeatingACommandIsHarmless() {
        Rig once = Rig.ready().command(HEAD, 90).pulse(4);
        Rig often = Rig.ready();
        for (int i = 0; i < 40; i++) {
            often.command(HEAD, 90).command(VEL, 0).command(OPEN).step(0.1);
        }
        assertThat(often.pose().headingDeg()).isCloseTo(once.pose().headingDeg(), within(0.01));
    }

    @Test
    void translationAndRotationAreTwoChannels() {
        Rig rig = Rig.ready().command(VEL, 200).command(HEAD, 90).pulse(4);
        SipView sip = rig.nextSip();
        assertThat(sip.headingDeg()).isCloseTo(90, within(0.5));
        assertThat(List.of(sip.left(), sip.right())).containsExactly(200, 200);
        assertThat(rig.command(MOVE, 100).command(RVEL, 20).step(0.5).nextSip().turnRateTenths())
                .isEqualTo(200);
    }

    @Test
    void rampsAreStraight() {
        Rig rig = Rig.ready().command(5, 300).command(VEL, 250);
        for (int speed = 30; speed <= 240; speed += 30) {
            assertThat(rig.nextSip().left()).isEqualTo(speed);
        }
        assertThat(rig.nextSip().left()).isEqualTo(250);
    }

    @ParameterizedTest
    @ValueSource(ints = {500, -500, 3000, -40})
    void moveArrivesForwardAndBackward(int mm) {
        Rig rig = Rig.ready().command(MOVE, mm).pulse(14);
        assertThat(rig.pose().xMm()).isCloseTo(mm, within(0.1));
    }

    @Test
    void theWatchdogStopsItAfterTwoSecondsAndItResumes() {
        Rig rig = Rig.ready().command(VEL, 300).step(1.9);
        assertThat(rig.nextSip().left()).isGreaterThan(260);
        assertThat(rig.step(2).nextSip().left()).isZero();
        assertThat(rig.step(1).sips()).as("the session goes on").hasSize(10);
        assertThat(rig.command(0).nextSip().left()).isEqualTo(30);
        assertThat(rig.pulse(1.2).nextSip().left()).isEqualTo(300);
    }

    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void afterCloseOrWithoutItTheRobotStopsAndTheNextClientIsServed(boolean closes) {
        Rig rig = Rig.ready().command(VEL, 300).step(1);
        if (closes) {
            rig.command(CLOSE);
            assertThat(rig.line.isOpen()).isFalse();
        }
        rig.reconnect();
        rig.step(2);
        assertThat(rig.body().speedMmPerSec()).isZero();
        assertThat(rig.shakeHands().nextSip().flags()).isEqualTo(0x1E);
    }

    @Test
    void odometryOfANoisyRobotIsOffByOneToTwoPercentAndTwoToFivePercentOfHeading() {
        for (long seed = 1; seed <= 20; seed++) {
            Rig rig = new Rig(new Pose(-2000, 0, 0), Noise.seeded(seed), "p3dx-sh").shakeHands();
            rig.command(ENABLE, 1).command(MOVE, 2000).pulse(10);
            assertThat(Math.abs(rig.pose().distanceTo(new Pose(-2000, 0, 0)) / 2000 - 1))
                    .isBetween(0.0095, 0.0205);
            double before = rig.pose().headingDeg();
            rig.command(HEAD, 90).pulse(4);
            double turned = Pose.normalised(rig.pose().headingDeg() - before);
            assertThat(Math.abs(turned / 90 - 1)).isBetween(0.0195, 0.0505);
        }
    }

    private static Rig rig(String model) {
        return new Rig(new Pose(0, 0, 0), Noise.exact(), model);
    }

    /** The data of a packet as text. */
    private static String text(byte[] packet) {
        return new String(packet, 4, packet.length - 6, StandardCharsets.ISO_8859_1);
    }
}
