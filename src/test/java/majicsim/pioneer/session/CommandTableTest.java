package majicsim.pioneer.session;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.ToIntFunction;
import java.util.stream.Stream;
import majicsim.pioneer.Rig;
import majicsim.pioneer.SipView;
import majicsim.pioneer.devices.Tone;
import majicsim.pioneer.model.Setting;
import majicsim.pioneer.model.Settings;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Every command of the ARCOS sheet's tables (6.1, 6.2), line by line. */
class CommandTableTest {
    /** They end the session or the controller's attention: shown by tests of their own. */
    private static final Set<Integer> ENDINGS = Set.of(2, 253, 255);

    /** A command as a client sends it, and what must be seen afterwards on a robot that stands with its motors on. */
    record Row(int number, String name, Consumer<Rig> client, ToIntFunction<Rig> seen, int expected) {
        @Override
        public String toString() {
            return number + " " + name;
        }
    }

    static Stream<Row> obeyed() {
        return Stream.of(
                sip(0, "PULSE", 0, SipView::flags, 0x1F),
                sip(1, "OPEN", 1, SipView::flags, 0x1F),
                sip(4, "ENABLE", 0, SipView::flags, 0x1E),
                config(5, "SETA", 210, "TRANSACC"),
                config(6, "SETV", 220, "TRANSVELMAX"),
                sip(7, "SETO", 0, SipView::x, 0),
                later(8, "MOVE", 100, SipView::x, 100),
                later(9, "ROTATE", 20, SipView::turnRateTenths, 200),
                config(10, "SETRV", 70, "ROTVELMAX"),
                later(11, "VEL", 150, SipView::left, 150),
                later(12, "HEAD", 45, SipView::heading, 512),
                later(13, "DHEAD", 45, SipView::heading, 512),
                packet(17, "JOYINFO", 1, 0xF8),
                config(18, "CONFIG", 1, "WATCHDOG", 2000),
                packet(19, "ENCODER", 1, 0x90),
                later(21, "RVEL", -20, SipView::turnRateTenths, -200),
                later(22, "DCHEAD", 45, SipView::heading, 512),
                config(23, "SETRA", 80, "ROTACC"),
                sip(28, "SONAR", 0, SipView::flags, 0x01),
                later(29, "STOP", 0, SipView::left, 0),
                sip(30, "DIGOUT", 0x0F05, SipView::digitalOut, 0xF5),
                later(32, "VEL2", 0x0A0A, SipView::left, 200),
                sip(33, "GRIPPER", 1, SipView::gripper, 0b0001_0100),
                sip(35, "ADSEL", 3, SipView::analogPort, 3),
                packet(37, "GRIPREQUEST", 1, 0xE0),
                packet(40, "IOREQUEST", 1, 0xF0),
                config(48, "SONARCYCLE", 60, "SONARCYCLE"),
                config(50, "HOSTBAUD", 2, "HOSTBAUD"),
                later(55, "ESTOP", 0, SipView::left, 0),
                later(57, "QSTOP", 0, SipView::left, 0),
                row(58, "GYRO", 1, rig -> rig.packets(0x98, 0.2).size(), 2),
                packet(62, "BATTERYINFO", 1, 0xFA),
                row(
                        230,
                        "SIM_LRF_ENABLE",
                        1,
                        rig -> Math.min(1, rig.packets(0x60, 0.2).size()),
                        1),
                row(237, "SIM_STAT", 2, rig -> rig.packets(0x62, 0.2).size(), 2),
                sip(239, "SIM_EXIT", 0, SipView::flags, 0x1F),
                sip(250, "BATTEST", 117, SipView::battery, 117));
    }

    static Stream<Row> obeyedWithMoreThanANumber() {
        return Stream.of(
                new Row(3, "POLLING", rig -> rig.text(3, (byte) 1), rig -> discsHeard(rig), 1),
                new Row(15, "SAY", rig -> rig.text(15, (byte) 5, (byte) 69), rig -> hertzHeard(rig), 440),
                turning(20, "SETRVDIR", rig -> rig.command(20, 10).command(21, 60), 100),
                turning(20, "SETRVDIR", rig -> rig.command(20, -10).command(21, 60), 600),
                new Row(36, "GRIPPERVAL", rig -> rig.command(33, 16).command(36, 25), rig -> graspTime(rig), 25),
                echo(42, "TTY2", rig -> rig.command(43, 1).text(42, (byte) 7), 0xB0),
                echo(43, "GETAUX", rig -> rig.text(42, (byte) 7).command(43, 1), 0xB0),
                echo(60, "TTY4", rig -> rig.command(61, 1).text(60, (byte) 7), 0xC8),
                echo(61, "GETAUX3", rig -> rig.text(60, (byte) 7).command(61, 1), 0xC8),
                echo(66, "TTY3", rig -> rig.command(67, 1).text(66, (byte) 7), 0xB8),
                echo(67, "GETAUX2", rig -> rig.text(66, (byte) 7).command(67, 1), 0xB8),
                new Row(
                        45,
                        "TCM2",
                        rig -> rig.command(45, 1),
                        rig -> rig.nextSip().compass(),
                        0),
                new Row(
                        68,
                        "CHARGE",
                        rig -> chargeWithout(rig),
                        rig -> rig.nextSip().flags(),
                        0x1F),
                new Row(
                        92,
                        "SOUNDTOG",
                        rig -> rig.command(92, 0).text(15, (byte) 5, (byte) 69),
                        rig -> hertzHeard(rig),
                        0),
                new Row(
                        224,
                        "SIM_SET_POSE",
                        rig -> elsewhere(rig),
                        rig -> (int) rig.pose().xMm(),
                        1000),
                new Row(
                        225,
                        "SIM_RESET",
                        rig -> elsewhere(rig).command(225, 0),
                        rig -> (int) rig.pose().xMm(),
                        0),
                new Row(
                        238,
                        "SIM_MESSAGE",
                        rig -> rig.text(238, (byte) 'h'),
                        rig -> rig.nextSip().flags(),
                        0x1F));
    }

    static Stream<Row> stored() {
        return Stream.of(
                config(5, "SETA", -230, "TRANSDECEL", 230),
                config(23, "SETRA", -90, "ROTDECEL", 90),
                config(38, "GYROCALCW", 11, "GYROCW"),
                config(39, "GYROCALCCW", 12, "GYROCCW"),
                setting(44, "BUMPSTALL", 1, Setting.BUMPSTALL),
                setting(47, "JOYDRIVE", 1, Setting.JOYDRIVE),
                setting(49, "MOVINGBLINK", 1, Setting.MOVINGBLINK),
                config(51, "AUX1BAUD", 1, "AUX1BAUD"),
                config(52, "AUX2BAUD", 2, "AUX2BAUD"),
                config(53, "AUX3BAUD", 3, "AUX3BAUD"),
                setting(56, "E_STALL", 0, Setting.E_STALL),
                setting(65, "CALCOMP", 1, Setting.CALCOMP),
                config(82, "ROTKP", 1, "ROTKP"),
                config(83, "ROTKV", 2, "ROTKV"),
                config(84, "ROTKI", 3, "ROTKI"),
                config(85, "TRANSKP", 4, "TRANSKP"),
                config(86, "TRANSKV", 5, "TRANSKV"),
                config(87, "TRANSKI", 6, "TRANSKI"),
                config(88, "REVCOUNT", 16000, "REVCOUNT"),
                config(89, "DRIFTFACTOR", -7, "DRIFTFACTOR"),
                config(93, "TICKSMM", 130, "TICKSMM"));
    }

    /** Arm, power switches, sideways motion, reports of other robots, the simulator's, numbers that mean nothing. */
    static Stream<Integer> ignored() {
        List<Integer> arm = Stream.iterate(70, n -> n + 1).limit(12).toList();
        List<Integer> power = List.of(95, 96, 97, 98, 125, 126, 127, 128, 129);
        List<Integer> others = List.of(110, 113, 123, 124, 149, 150, 14, 16, 34, 199, 254);
        return Stream.of(arm, power, others).flatMap(List::stream);
    }

    static Stream<Integer> allNumbers() {
        return Stream.iterate(0, n -> n + 1).limit(256).filter(n -> !ENDINGS.contains(n));
    }

    @ParameterizedTest
    @MethodSource({"obeyed", "obeyedWithMoreThanANumber", "stored"})
    void commandsOfTheTableDoAsDescribed(Row row) {
        assertThat(Command.of(row.number).map(Enum::name)).contains(row.name);
        Rig rig = Rig.ready(Rig.EQUIPPED);
        rig.line.take();
        row.client.accept(rig);
        assertThat(row.seen.applyAsInt(rig)).isEqualTo(row.expected);
    }

    @ParameterizedTest
    @MethodSource("stored")
    void whatWasStoredFallsBackWithTheEndOfTheSession(Row row) {
        Rig rig = Rig.ready();
        int before = row.seen.applyAsInt(rig);
        row.client.accept(rig);
        rig.command(2, 1).reconnect();
        assertThat(row.seen.applyAsInt(rig.shakeHands())).isEqualTo(before);
    }

    @ParameterizedTest
    @MethodSource("ignored")
    void otherNumbersAreIgnored(int number) {
        Rig rig = Rig.ready().command(number, 1);
        assertThat(Command.of(number)).isEmpty();
        assertThat(rig.nextSip().flags()).isEqualTo(0x1F);
    }

    @ParameterizedTest
    @MethodSource("allNumbers")
    void everyCommandIsTakenBareAndWithAnyArgument(int number) {
        Rig rig = Rig.ready();
        for (String argument :
                List.of("", "3B", "3B 00 00", "3B 02", "1B 01 00", "1B", "2B", "2B 02 10 45", "2B FF 41")) {
            rig.packet(number, argument).step(0.02);
        }
        assertThat(rig.pulse(0.4).sips()).hasSizeGreaterThanOrEqualTo(4);
        assertThat(rig.config().number("WATCHDOG")).isEqualTo(2000);
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "3B 01 00", "1B 01 00", "3B"})
    void closeEndsTheSessionInEveryForm(String argument) {
        assertThat(Rig.ready().packet(2, argument).line.isOpen()).isFalse();
    }

    private static Row sip(int number, String name, int argument, ToIntFunction<SipView> seen, int expected) {
        return row(number, name, argument, rig -> seen.applyAsInt(rig.nextSip()), expected);
    }

    private static Row later(int number, String name, int argument, ToIntFunction<SipView> seen, int expected) {
        return row(number, name, argument, rig -> seen.applyAsInt(rig.pulse(4).nextSip()), expected);
    }

    private static Row config(int number, String name, int argument, String field) {
        return config(number, name, argument, field, argument);
    }

    private static Row config(int number, String name, int argument, String field, int expected) {
        return row(number, name, argument, rig -> rig.config().number(field), expected);
    }

    private static Row setting(int number, String name, int argument, Setting setting) {
        return row(number, name, argument, rig -> settings(rig).get(setting), argument);
    }

    private static Row packet(int number, String name, int argument, int type) {
        return row(number, name, argument, rig -> rig.packets(type, 0.2).size(), 1);
    }

    private static Row row(int number, String name, int argument, ToIntFunction<Rig> seen, int expected) {
        return new Row(number, name, rig -> rig.command(number, argument), seen, expected);
    }

    private static Row turning(int number, String name, Consumer<Rig> client, int expectedTenths) {
        return new Row(number, name, client, rig -> rig.pulse(2).nextSip().turnRateTenths(), expectedTenths);
    }

    private static Row echo(int number, String name, Consumer<Rig> client, int type) {
        return new Row(number, name, client, rig -> rig.packets(type, 0.2).get(0)[4], 7);
    }

    private static Settings settings(Rig rig) {
        return rig.robot.board().devices().settings();
    }

    private static int discsHeard(Rig rig) {
        return (int) rig.pulse(2).sips().stream()
                .flatMap(sip -> sip.sonar().keySet().stream())
                .distinct()
                .count();
    }

    private static int hertzHeard(Rig rig) {
        List<Tone> played = rig.robot.handling().played();
        return played.isEmpty() ? 0 : (int) played.get(0).hertz();
    }

    private static int graspTime(Rig rig) {
        return rig.command(37, 1).packets(0xE0, 0.1).get(0)[6];
    }

    private static void chargeWithout(Rig rig) {
        rig.robot.handling().plugCharger(true);
        rig.command(68, 0);
    }

    private static Rig elsewhere(Rig rig) {
        return rig.packet(224, "3B E8 03 00 00 00 00 00 00 00 00 00 00");
    }
}
