package majic.inlab;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.OptionalInt;
import java.util.function.BooleanSupplier;
import majic.act.NoActs;
import majic.bot.BotListener;
import majic.bot.BotState;
import majic.bot.MajicBot;
import majic.bot.Pose;
import majic.environment.Settings;
import majic.log.Line;
import majic.log.SessionLog;
import majic.program.Plugins;
import majic.script.MajicParser;
import majic.script.Session;
import majic.simulation.SimulatedLab;
import majic.team.BotFactory;
import majic.team.Member;
import majic.team.Team;
import majic.time.TimeSource.Membership;
import majicsim.LabOptions;
import majicsim.hemisson.options.HemissonOptions;
import majicsim.mavlink.MavlinkOptions;
import majicsim.ros.options.RosOptions;

/**
 * Holds a stepped lab, a team and a session on it, for one test. The creating thread is registered with the lab's
 * clock: time advances only while it waits. All connections are real sockets.
 */
public final class LabRig implements AutoCloseable {
    private static final double LONGEST_WAIT_S = 3 * 3600;

    private final SimulatedLab lab;
    private final Membership membership;
    private final Team team;
    private final Session session;
    private final MajicParser parser;
    private final BotListener news = new News();
    private final List<String> said = Collections.synchronizedList(new ArrayList<>());

    private LabRig(LabOptions options) {
        try {
            lab = SimulatedLab.stepped(options);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        membership = lab.time().join();
        BotFactory factory = new BotFactory(Plugins.in(Path.of("none")).types(), Settings.inMemory());
        factory.useLab(lab);
        team = new Team(lab.time());
        session = new Session(team, factory, SessionLog.none(), NoActs.here(), () -> {});
        session.addListener(this::hear);
        parser = MajicParser.pipe(session);
    }

    /** Creates a lab without noise and without connected robots. */
    public static LabRig exact() {
        return new LabRig(LabOptions.exactOnFreePorts());
    }

    /** Creates a given lab without connected robots. */
    public static LabRig of(LabOptions options) {
        return new LabRig(options);
    }

    /** Creates a lab as {@link #exact()}, with this Pioneer and its extras, as {@code p3dx-sh+gripper}. */
    public static LabRig exactWithPioneer(String model) {
        return new LabRig(LabOptions.exactOnFreePorts().withPioneer(model));
    }

    /** Creates a lab as {@link #exact()}, with this Hemisson and its extras, as {@code kteam+camera+overrun}. */
    public static LabRig exactWithHemisson(String model) {
        return new LabRig(LabOptions.exactOnFreePorts().withHemisson(HemissonOptions.parse(model)));
    }

    /** Creates a lab as {@link #exact()}, with these MAVLink vehicles, as {@code rover+ready,copter}. */
    public static LabRig exactWithMavlink(String vehicles) {
        return new LabRig(LabOptions.exactOnFreePorts().withMavlink(MavlinkOptions.parse(vehicles)));
    }

    /** Creates a lab as {@link #exact()}, with this ROS robot, as {@code 2+stamped}. */
    public static LabRig exactWithRos(String model) {
        return new LabRig(LabOptions.exactOnFreePorts().withRos(RosOptions.parse(model)));
    }

    /** Creates a lab with noise and jitter, without connected robots. */
    public static LabRig noisy(long seed) {
        return new LabRig(LabOptions.exactOnFreePorts().withNoise(seed));
    }

    /** Adds all robots: 1 Aibo, 2 Pioneer, 3 Hemisson, and 4 the ROS robot if the lab has one. */
    public LabRig withAllRobots() {
        lab.robots().forEach(this::add);
        return this;
    }

    /** Connects to the lab's robot of a type and adds it to the team. */
    public MajicBot add(String type) {
        MajicBot bot = session.factory().create("sim:" + type);
        bot.connect();
        team.add(bot, OptionalInt.empty());
        return bot;
    }

    private void hear(Line line) {
        if (line.kind() != Line.Kind.COMMAND) {
            said.add(line.text());
        }
    }

    /** Runs lines of MAJIC Script as a pipe would, and waits until all is done. */
    public List<String> run(String... lines) throws InterruptedException {
        forget();
        for (String line : lines) {
            parser.parseText(line);
        }
        parser.awaitAll();
        return said();
    }

    /** Starts a line of MAJIC Script, without waiting for its end. */
    public void say(String line) {
        forget();
        parser.parseText(line);
    }

    private void forget() {
        session.flush();
        said.clear();
    }

    /** Returns the output since the last {@link #run} or {@link #say}, once the listener has received all of it. */
    public List<String> said() {
        session.flush();
        synchronized (said) {
            return List.copyOf(said);
        }
    }

    /**
     * Waits by the lab's clock; tests the condition again at each event of the team and each new reading of a robot.
     */
    public boolean await(BooleanSupplier condition) throws InterruptedException {
        List<MajicBot> bots = team.members().stream().map(Member::bot).toList();
        bots.forEach(bot -> bot.addListener(news));
        try {
            return team.changes().await(condition, LONGEST_WAIT_S);
        } finally {
            bots.forEach(bot -> bot.removeListener(news));
        }
    }

    /** Runs a task after a time of the lab, on a thread of its own. */
    public void after(double seconds, Runnable task) {
        lab.time()
                .thread("meanwhile", () -> {
                    try {
                        lab.time().sleep(seconds);
                        task.run();
                    } catch (InterruptedException e) {
                        Thread.currentThread().interrupt();
                    }
                })
                .start();
    }

    public Pose truePose(String type) {
        Pose pose = lab.truePoses().get(type);
        if (pose == null) {
            throw new IllegalArgumentException("no " + type + " in the lab");
        }
        return pose;
    }

    public SimulatedLab lab() {
        return lab;
    }

    public Team team() {
        return team;
    }

    public Session session() {
        return session;
    }

    @Override
    public void close() {
        team.close();
        membership.close();
        lab.close();
    }

    /** Signals threads that wait for readings. */
    private final class News implements BotListener {
        @Override
        public void stateChanged(MajicBot bot, BotState state) {
            team.changes().raise();
        }
    }
}
