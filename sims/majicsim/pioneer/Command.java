package majicsim.pioneer;

import java.util.Arrays;
import java.util.Map;
import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.function.Function;
import java.util.stream.Collectors;
import majicsim.world.Pose;

/** The commands that the controller knows, by the manual's names and numbers, and what each does (ARCOS sheet 6). */
enum Command {
    PULSE(0, (session, argument) -> {}),
    OPEN(1, (session, argument) -> session.open()),
    CLOSE(2, (session, argument) -> session.close()),
    ENABLE(4, (session, argument) -> session.drive().enable(argument.isOn())),
    SETA(5, (session, argument) -> session.drive().limitTranslation(old -> old.withRamp(argument.integer()))),
    SETV(6, (session, argument) -> session.drive().limitTranslation(old -> old.withSpeed(argument.integer()))),
    SETO(7, (session, argument) -> session.drive().setOdometry(poseOf(argument))),
    MOVE(8, (session, argument) -> session.move(argument.integer())),
    ROTATE(9, (session, argument) -> session.drive().turnRate(argument.integer())),
    SETRV(10, (session, argument) -> session.drive().limitRotation(old -> old.withSpeed(argument.integer()))),
    VEL(11, (session, argument) -> session.drive().velocity(argument.integer())),
    HEAD(12, (session, argument) -> session.drive().heading(argument.integer())),
    DHEAD(13, (session, argument) -> session.drive().headingFromHere(argument.integer())),
    CONFIG(18, (session, argument) -> session.send(session.board().config())),
    ENCODER(19, (session, argument) -> session.reports().encoders().ask(argument.integer())),
    RVEL(21, (session, argument) -> session.drive().turnRate(argument.integer())),
    DCHEAD(22, (session, argument) -> session.drive().headingFromSetPoint(argument.integer())),
    SETRA(23, (session, argument) -> session.drive().limitRotation(old -> old.withRamp(argument.integer()))),
    SONAR(28, (session, argument) -> session.board().sonar().switchArrays(argument.integer())),
    STOP(29, (session, argument) -> session.drive().halt()),
    DIGOUT(30, (session, argument) -> session.board().digitalOut(argument.lowByte(), argument.highByte())),
    VEL2(32, (session, argument) -> session.wheels(argument.highByte(), argument.lowByte())),
    ADSEL(35, (session, argument) -> session.board().analogPort(argument.integer())),
    IOREQUEST(40, (session, argument) -> session.reports().inputsAndOutputs().ask(argument.integer())),
    SONARCYCLE(48, (session, argument) -> session.board().sonar().cycleMs(argument.integer())),
    ESTOP(55, (session, argument) -> session.drive().emergencyStop()),
    QSTOP(57, (session, argument) -> session.drive().emergencyStop()),
    BATTERYINFO(62, (session, argument) -> session.reports().batteries().ask(argument.integer())),
    SIM_SET_POSE(
            224,
            (session, argument) ->
                    session.board().place(new Pose(argument.int32(0), argument.int32(1), argument.int32(2)))),
    SIM_RESET(225, (session, argument) -> session.board().backToStart()),
    SIM_STAT(237, (session, argument) -> session.reports().simStat().ask(argument.integer())),
    SIM_MESSAGE(238, (session, argument) -> session.show(argument.text())),
    BATTEST(250, (session, argument) -> session.board().pretendBattery(argument.integer())),
    RESET(253, (session, argument) -> session.close());

    private static final Map<Integer, Command> BY_NUMBER =
            Arrays.stream(values()).collect(Collectors.toMap(command -> command.number, Function.identity()));

    private final int number;
    private final BiConsumer<Session, Argument> effect;

    Command(int number, BiConsumer<Session, Argument> effect) {
        this.number = number;
        this.effect = effect;
    }

    /** The command of this number; empty for those that this controller ignores. */
    static Optional<Command> of(int number) {
        return Optional.ofNullable(BY_NUMBER.get(number));
    }

    void run(Session session, Argument argument) {
        effect.accept(session, argument);
    }

    /** SETO alone means zero; with three numbers behind the type byte, those. */
    private static Pose poseOf(Argument argument) {
        return argument.hasInt16(2)
                ? new Pose(argument.int16(0), argument.int16(1), argument.int16(2))
                : new Pose(0, 0, 0);
    }
}
