package majic.pioneer.aria;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.mockito.ArgumentMatchers.any;
import static org.mockito.ArgumentMatchers.anyInt;
import static org.mockito.ArgumentMatchers.anyShort;
import static org.mockito.Mockito.mock;
import static org.mockito.Mockito.verify;
import static org.mockito.Mockito.verifyNoInteractions;
import static org.mockito.Mockito.when;

import com.mobilerobots.Aria.ArRobot;
import java.util.stream.Stream;
import majic.bot.BotException;
import majic.pioneer.arcos.ArcosCommand;
import majic.pioneer.arcos.Packet;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.mockito.Mockito;

class AriaCommandsTest {
    private final ArRobot robot = mock(
            ArRobot.class,
            call -> call.getMethod().getReturnType() == boolean.class ? true : Mockito.RETURNS_DEFAULTS.answer(call));

    /** What must be called. */
    private interface Expected {
        void on(ArRobot robot);
    }

    static Stream<Arguments> commands() {
        return Stream.of(
                command(ArcosCommand.VEL.packet(-250), robot -> robot.setVel(-250)),
                command(ArcosCommand.RVEL.packet(15), robot -> robot.setRotVel(15)),
                command(ArcosCommand.STOP.packet(), ArRobot::stop),
                command(ArcosCommand.ENABLE.packet(1), ArRobot::enableMotors),
                command(ArcosCommand.ENABLE.packet(0), ArRobot::disableMotors),
                command(ArcosCommand.SETV.packet(1000), robot -> robot.setTransVelMax(1000)),
                command(ArcosCommand.SETRV.packet(100), robot -> robot.setRotVelMax(100)),
                command(ArcosCommand.SETA.packet(300), robot -> robot.setTransAccel(300)),
                command(ArcosCommand.SETA.packet(-500), robot -> robot.setTransDecel(500)),
                command(ArcosCommand.SETRA.packet(90), robot -> robot.setRotAccel(90)),
                command(ArcosCommand.SETRA.packet(-80), robot -> robot.setRotDecel(80)),
                command(ArcosCommand.SONAR.packet(3), robot -> robot.comInt((short) 28, (short) 3)),
                command(ArcosCommand.GRIPPERVAL.packet(-20), robot -> robot.comInt((short) 36, (short) -20)),
                command(
                        ArcosCommand.DIGOUT.packet(0x85, 0xF0),
                        robot -> robot.com2Bytes((short) 30, (char) 0xF0, (char) 0x85)),
                command(
                        ArcosCommand.SAY.packet(new byte[] {10, 72, 5, 0}),
                        robot -> robot.comStrN((short) 15, "\n\u0048\u0005\u0001", 4)),
                command(ArcosCommand.QSTOP.packet(), robot -> robot.com((short) 57)));
    }

    @Test
    void aCommandThatTheInstalledAriaHasWithOtherParametersIsRefused() {
        when(robot.comStrN(anyShort(), any(), anyInt())).thenThrow(new NoSuchMethodError("comStrN"));

        assertThatThrownBy(() -> AriaCommands.execute(robot, ArcosCommand.SAY.packet(new byte[] {10, 72})))
                .isInstanceOf(BotException.class)
                .hasMessage("this ARIA cannot send SAY: comStrN");
    }

    private static Arguments command(Packet packet, Expected expected) {
        return Arguments.of(packet, expected);
    }

    @ParameterizedTest
    @MethodSource("commands")
    void commandsBecomeCallsOfAria(Packet packet, Expected expected) {
        AriaCommands.execute(robot, packet);

        expected.on(verify(robot));
        Mockito.verifyNoMoreInteractions(robot);
    }

    @Test
    void anEmergencyStopLeavesAriaNoVelocityToRepeat() {
        AriaCommands.execute(robot, ArcosCommand.ESTOP.packet());

        verify(robot).setVel(0);
        verify(robot).setRotVel(0);
        verify(robot).com((short) 55);
    }

    @Test
    void pulsesAreLeftToAria() {
        AriaCommands.execute(robot, ArcosCommand.PULSE.packet());

        verifyNoInteractions(robot);
    }

    @Test
    void tonesThatAriaCannotSendAreRefused() {
        assertThatThrownBy(() -> AriaCommands.execute(robot, ArcosCommand.SAY.packet(new byte[] {10, (byte) 200})))
                .isInstanceOf(BotException.class)
                .hasMessage("ARIA cannot send tones above note 127 or longer than 2.54 s");
    }

    @Test
    void aCommandThatAriaDoesNotSendIsAnError() {
        when(robot.com(anyShort())).thenReturn(false);

        assertThatThrownBy(() -> AriaCommands.execute(robot, ArcosCommand.QSTOP.packet()))
                .isInstanceOf(BotException.class)
                .hasMessage("ARIA could not send QSTOP");
        assertThat(Mockito.mockingDetails(robot).getInvocations()).hasSize(1);
    }
}
