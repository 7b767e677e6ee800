package majic.mavlink;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import majic.bot.BotAddress;
import majic.bot.BotListener;
import majic.bot.MajicBot;
import majic.bot.Pose;
import majic.drivertest.ScriptedPeer;
import majic.drivertest.TestClock;
import majic.drivertest.TestedRobot;
import majic.environment.BotEnvironment;
import majic.environment.Settings;

/** A scripted vehicle behind a TCP port, and its driver. */
final class DrivenRover implements TestedRobot, ScriptedPeer.Robot {
    final ScriptedPeer peer = new ScriptedPeer(this);
    final ScriptedRover rover = new ScriptedRover(peer::send);

    /** Other vehicles behind the same port. */
    final List<ScriptedRover> others = new CopyOnWriteArrayList<>();

    final List<String> notices = new ArrayList<>();
    private final MajicMavlink bot;

    DrivenRover() {
        this("");
    }

    DrivenRover(String options) {
        bot = new MajicMavlink(
                BotAddress.parse("mavlink://" + peer.address() + options),
                new BotEnvironment(peer.clock().time(), Settings.inMemory()));
        bot.addListener(new BotListener() {
            @Override
            public void notice(MajicBot robot, String message) {
                synchronized (notices) {
                    notices.add(message);
                }
            }
        });
    }

    /** A driver of another vehicle on the same connection. */
    MajicMavlink another(String options) {
        return new MajicMavlink(
                BotAddress.parse("mavlink://" + peer.address() + options),
                new BotEnvironment(peer.clock().time(), Settings.inMemory()));
    }

    /** One that is armed, and connected. */
    DrivenRover ready() {
        rover.armed = true;
        bot.connect();
        return this;
    }

    TestClock clock() {
        return peer.clock();
    }

    void pass(double seconds) {
        long end = peer.millis() + (long) (1000 * seconds);
        clock().until(() -> peer.millis() >= end);
    }

    List<String> notices() {
        synchronized (notices) {
            return List.copyOf(notices);
        }
    }

    @Override
    public void received(ScriptedPeer client, byte[] bytes) {
        rover.receive(bytes);
        others.forEach(other -> other.receive(bytes));
    }

    @Override
    public void step(ScriptedPeer client) {
        rover.step();
        others.forEach(ScriptedRover::step);
    }

    @Override
    public MajicMavlink bot() {
        return bot;
    }

    @Override
    public Pose truePose() {
        return rover.pose;
    }

    @Override
    public void cut() {
        peer.hangUp();
    }

    @Override
    public void fallSilent() {
        rover.silent = true;
    }

    @Override
    public void block() {
        rover.blocked = true;
    }

    @Override
    public void unblock() {
        rover.blocked = false;
    }

    @Override
    public void close() {
        bot.close();
        peer.close();
    }
}
