package majicsim.aibo;

import java.util.List;
import java.util.stream.Collectors;

/**
 * The programs on the simulated memory stick: the stick's functions with their durations (URBI sheet, section 15), in
 * newly written code. Functions of the stick that only serve others, and those that watch for obstacles, do nothing.
 */
final class MemoryStickScript {
    private static final String PROGRAM = """
            robot.walkspeed = 1000; robot.turnspeed = 1000;
            system.name = "ERS-7"; global.name = "ERS-7";
            walk.turnamount = 0; walk.direction = 1; walk.coef[1] = 1; walk.coef[2] = 1/2;
            walk.mean[1][1] = -17.4; walk.mean[1][2] = 10; walk.mean[1][3] = 80.5;
            walk.mean[2][1] = -28.8; walk.mean[2][2] = 11.1; walk.mean[2][3] = 90.3;
            turn.direction = 1; turn.coef[1] = 1; turn.coef[2] = 1/2; turn.coef[3] = 1/3;
            turn.mean[1][1] = -19.4; turn.mean[1][2] = 17.8; turn.mean[1][3] = 82.2;
            turn.mean[2][1] = -20; turn.mean[2][2] = 12.8; turn.mean[2][3] = 89.3;
            robot.bt = 0; global.hcounter = 0; global.bk = 0;
            class colormap;
            ball = new colormap;
            ball.a = 0.95; ball.threshold = 0.0015; ball.load = 1;
            function robot.MyguessPosition() { return lab.posture() };
            function robot.stopwalk() { stop walk };
            function robot.stopturn() { stop turn };
            function lab.pose(n, f1, f2, f3, h1, h2, h3, ms) {
              { neck.val = n time:1000 & headPan.val = 0 time:1000 & headTilt.val = 0 time:1000 & tailPan.val = 0 time:1000 }
              | lab.place(f1, f2, f3, h1, h2, h3, ms)
            };
            function lab.place(f1, f2, f3, h1, h2, h3, ms) {
              legF1.val = f1 time:ms & legF2.val = f2 time:ms & legF3.val = f3 time:ms &
              legH1.val = h1 time:ms & legH2.val = h2 time:ms & legH3.val = h3 time:ms
            };
            function robot.stand() { lab.pose(0, -20, 25, 90, -25, 10, 80, 2000) };
            function robot.sit() { lab.pose(-40, -45, -10, 10, -75, 15, 120, 2000) };
            function robot.beg() { lab.pose(-25, -20, 5, 115, -55, -10, 115, 2000) };
            function robot.lay() {
              head.val = 0 time:2000 & tail.val = 5 time:2000 & legF2.val = -5 time:2000 & legF3.val = 40 time:2000 &
              legH1.val = -120 time:2000 & legH2.val = 0 time:2000 & legH3.val = 120 time:2000
            };
            function robot.stretch() { lab.place(60, 0, 20, -20, 10, 60, 2000) };
            function robot.initial() { robot.stretch() | lab.place(55, -5, 40, -120, 0, 120, 1900) };
            function robot.StandUp() {
              a = robot.MyguessPosition();
              if (a == "stand") wait(300)
              else { lab.pose(-25, -6, 3.5, 30, -6, 3.5, 30, 6000) | headTilt.val = 22 time:300 }
            };
            function robot.SitDown() {
              a = robot.MyguessPosition();
              if (a == "sit") wait(300)
              else { lab.pose(-40, -26, -6, 20, -80, 19, 110, 10500) | headTilt.val = 5 time:300 }
            };
            function robot.LayDown() {
              a = robot.MyguessPosition();
              if (a == "lay") wait(300)
              else lab.pose(0, 0, -5, 40, -120, 0, 120, 3200)
            };
            function robot.stand2sit() { robot.sit() };
            function robot.stand2lay() { robot.lay() };
            function robot.sit2stand() { robot.stand() };
            function robot.sit2lay() { robot.lay() };
            function robot.lay2stand() { robot.stand() };
            function robot.swalk(n) { lab.place(-17.4, 10, 80.5, -28.8, 11.1, 90.3, 2400) | lab.stepwalk(n) };
            function robot.sturn(n) { lab.place(-19.4, 17.8, 82.2, -20, 12.8, 89.3, 700) | lab.stepturn(n) };
            function robot.JF(a, b) {};
            function robot.ctInitialPos() {}; function robot.swInitialPos() {};
            function robot.stdStandedUp() {}; function robot.stdSitedDown() {};
            function robot.NormalWalk(n) {}; function robot.odinitialization() {};
            function robot.ObstacleDetection(n) {}; function robot.obstaclealert() {}; function robot.redalarm() {};
            function robot.CliffDetection(n) {}; function robot.cliffinitialization() {}; function robot.cliffalert() {};
            function stand2sit.Head() {}; function sit2stand.Head() {};
            function stand2sit.J1F() {}; function stand2sit.J1H() {}; function stand2sit.J2F() {};
            function stand2sit.J2H() {}; function stand2sit.J3F() {}; function stand2sit.J3H() {};
            function sit2stand.J1F() {}; function sit2stand.J1H() {}; function sit2stand.J2F() {};
            function sit2stand.J2H() {}; function sit2stand.J3F() {}; function sit2stand.J3H() {};
            chintoggle: at (chinSensor.val > 0 ~ 2s) { if (headPan.load > 0) motors off else motors on },
            lowbattery: at (power() < 0.2) lowbattery.sounds = speaker.play("battery.wav"),
            anim: { ledF12.val = 1 & ledBFW.val = 0.5 sin:4s ampli:0.5 & ledBMW.val = 0.5 sin:4s ampli:0.5 phase:-1
              & ledBRW.val = 0.5 sin:4s ampli:0.5 phase:-2 },
            """;

    /** The program that runs in each new connection (URBI sheet, section 2). */
    static final String CLIENT = """
            if (speaker.play("client.wav")) noop,
            modeB.val = 1;
            power__shown = 101;
            power: whenever (round(power() * 100) < power__shown) {
              power__shown = round(power() * 100) | power: echo "Battery at " + power__shown + " %"
            },
            """;

    private MemoryStickScript() {}

    /**
     * The program that runs at the start.
     *
     * @param devices the devices for which the bare name means the field val
     */
    static String program(List<String> devices) {
        return devices.stream()
                .map(device -> "alias " + device + " " + device + ".val;\n")
                .collect(Collectors.joining("", "", PROGRAM));
    }
}
