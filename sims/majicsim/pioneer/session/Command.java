package majicsim.pioneer.session;

import java.util.Arrays;
import java.util.Map;
import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.function.Function;
import java.util.stream.Collectors;
import majicsim.pioneer.model.Setting;
import majicsim.pioneer.packet.Argument;
import majicsim.pioneer.report.ConfigReport;
import majicsim.pioneer.report.Report;
import majicsim.world.Pose;

/** The commands of the controller with the manual's names and numbers, and their effects (ARCOS sheet 6). */
public enum Command {
    PULSE(0, (session, argument) -> {}),
    OPEN(1, (session, argument) -> session.open()),
    CLOSE(2, (session, argument) -> session.close()),
    POLLING(3, (session, argument) -> session.board().sonar().order(argument.bytes())),
    ENABLE(4, (session, argument) -> session.board().enable(argument.isOn())),
    SETA(5, (session, argument) -> session.drive().limitTranslation(old -> old.withRamp(argument.integer()))),
    SETV(6, (session, argument) -> session.drive().limitTranslation(old -> old.withSpeed(argument.integer()))),
    SETO(7, (session, argument) -> session.drive().setOdometry(poseOf(argument))),
    MOVE(8, (session, argument) -> session.board().move(argument.integer())),
    ROTATE(9, (session, argument) -> session.drive().turnRate(argument.integer())),
    SETRV(10, (session, argument) -> session.drive().limitRotation(old -> old.withSpeed(argument.integer()))),
    VEL(11, (session, argument) -> session.drive().velocity(argument.integer())),
    HEAD(12, (session, argument) -> session.drive().heading(argument.integer())),
    DHEAD(13, (session, argument) -> session.drive().headingFromHere(argument.integer())),
    SAY(15, (session, argument) -> session.devices().buzzer().say(argument.bytes())),
    JOYINFO(17, asksFor(Report.JOYSTICK)),
    CONFIG(18, (session, argument) -> session.send(ConfigReport.of(session.board()))),
    ENCODER(19, asksFor(Report.ENCODER)),
    SETRVDIR(20, (session, argument) -> session.drive().limitRotation(old -> old.withSpeedTowards(argument.integer()))),
    RVEL(21, (session, argument) -> session.drive().turnRate(argument.integer())),
    DCHEAD(22, (session, argument) -> session.drive().headingFromSetPoint(argument.integer())),
    SETRA(23, (session, argument) -> session.drive().limitRotation(old -> old.withRamp(argument.integer()))),
    SONAR(28, (session, argument) -> session.board().sonar().switchArrays(argument.integer())),
    STOP(29, (session, argument) -> session.drive().halt()),
    DIGOUT(30, (session, argument) -> session.devices().userPort().output(argument.lowByte(), argument.highByte())),
    VEL2(32, (session, argument) -> session.board().wheels(argument.highByte(), argument.lowByte())),
    GRIPPER(33, (session, argument) -> session.devices().gripper().order(argument.integer())),
    ADSEL(35, (session, argument) -> session.devices().userPort().show(argument.integer())),
    GRIPPERVAL(36, (session, argument) -> session.devices().gripper().value(argument.integer())),
    GRIPREQUEST(37, asksFor(Report.GRIPPER)),
    GYROCALCW(38, stores(Setting.GYRO_CLOCKWISE)),
    GYROCALCCW(39, stores(Setting.GYRO_COUNTERCLOCKWISE)),
    IOREQUEST(40, asksFor(Report.IO)),
    TTY2(42, (session, argument) -> session.aux(1).transmit(argument.bytes())),
    GETAUX(43, (session, argument) -> session.aux(1).request(argument.integer())),
    BUMPSTALL(44, stores(Setting.BUMPSTALL)),
    TCM2(45, (session, argument) -> session.devices().compass().enable(argument.isOn())),
    JOYDRIVE(47, stores(Setting.JOYDRIVE)),
    SONARCYCLE(48, (session, argument) -> session.board().sonar().cycleMs(argument.integer())),
    MOVINGBLINK(49, stores(Setting.MOVINGBLINK)),
    HOSTBAUD(50, (session, argument) -> session.devices().hostBaud().change(argument.integer())),
    AUX1BAUD(51, stores(Setting.AUX1_BAUD)),
    AUX2BAUD(52, stores(Setting.AUX2_BAUD)),
    AUX3BAUD(53, stores(Setting.AUX3_BAUD)),
    ESTOP(55, (session, argument) -> session.drive().emergencyStop()),
    E_STALL(56, stores(Setting.E_STALL)),
    QSTOP(57, (session, argument) -> session.drive().emergencyStop()),
    GYRO(58, (session, argument) -> session.reports().requestGyro(argument.isOn())),
    TTY4(60, (session, argument) -> session.aux(3).transmit(argument.bytes())),
    GETAUX3(61, (session, argument) -> session.aux(3).request(argument.integer())),
    BATTERYINFO(62, asksFor(Report.BATTERY)),
    CALCOMP(65, stores(Setting.CALCOMP)),
    TTY3(66, (session, argument) -> session.aux(2).transmit(argument.bytes())),
    GETAUX2(67, (session, argument) -> session.aux(2).request(argument.integer())),
    CHARGE(68, (session, argument) -> session.devices().charger().deploy(argument.isOn())),
    ROTKP(82, stores(Setting.ROTKP)),
    ROTKV(83, stores(Setting.ROTKV)),
    ROTKI(84, stores(Setting.ROTKI)),
    TRANSKP(85, stores(Setting.TRANSKP)),
    TRANSKV(86, stores(Setting.TRANSKV)),
    TRANSKI(87, stores(Setting.TRANSKI)),
    REVCOUNT(88, stores(Setting.REVCOUNT)),
    DRIFTFACTOR(89, stores(Setting.DRIFTFACTOR)),
    SOUNDTOG(92, (session, argument) -> session.devices().buzzer().mute(!argument.isOn())),
    TICKSMM(93, stores(Setting.TICKSMM)),
    SIM_SET_POSE(
            224,
            (session, argument) ->
                    session.board().place(new Pose(argument.int32(0), argument.int32(1), argument.int32(2)))),
    SIM_RESET(225, (session, argument) -> session.board().backToStart()),
    SIM_LRF_ENABLE(230, (session, argument) -> session.simulation().laser().enable(argument.integer())),
    SIM_LRF_SET_FOV_START(
            231, (session, argument) -> session.simulation().laser().from(argument.integer())),
    SIM_LRF_SET_FOV_END(232, (session, argument) -> session.simulation().laser().to(argument.integer())),
    SIM_LRF_SET_RES(233, (session, argument) -> session.simulation().laser().every(argument.integer())),
    SIM_CTRL(236, (session, argument) -> session.simulation().control(argument)),
    SIM_STAT(237, (session, argument) -> session.simulation().stat(argument.integer())),
    SIM_MESSAGE(238, (session, argument) -> SimControl.show(argument.text())),
    SIM_EXIT(239, (session, argument) -> SimControl.refuseToEnd()),
    BATTEST(250, (session, argument) -> session.devices().battery().pretend(argument.integer())),
    RESET(253, (session, argument) -> session.restart()),
    MAINTENANCE(255, (session, argument) -> session.maintain());

    private static final Map<Integer, Command> BY_NUMBER =
            Arrays.stream(values()).collect(Collectors.toMap(command -> command.number, Function.identity()));

    private final int number;
    private final BiConsumer<Session, Argument> effect;

    Command(int number, BiConsumer<Session, Argument> effect) {
        this.number = number;
        this.effect = effect;
    }

    /** The command of this number; empty for those that this controller ignores. */
    public static Optional<Command> of(int number) {
        return Optional.ofNullable(BY_NUMBER.get(number));
    }

    void run(Session session, Argument argument) {
        effect.accept(session, argument);
    }

    private static BiConsumer<Session, Argument> stores(Setting setting) {
        return (session, argument) -> session.devices().settings().set(setting, argument.integer());
    }

    private static BiConsumer<Session, Argument> asksFor(Report report) {
        return (session, argument) -> session.reports().ask(report, argument.integer());
    }

    /** SETO without an argument means zero; with three numbers behind the type byte, these numbers. */
    private static Pose poseOf(Argument argument) {
        return argument.hasInt16(2)
                ? new Pose(argument.int16(0), argument.int16(1), argument.int16(2))
                : new Pose(0, 0, 0);
    }
}
