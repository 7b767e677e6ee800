package majic.simulation;

import java.io.IOException;
import java.lang.System.Logger.Level;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import majic.bot.BotAddress;
import majic.bot.BotException;
import majic.bot.Pose;
import majic.file.NativeFolder;
import majic.lab.LabAccess;
import majic.lab.LabClock;
import majic.lab.Pacing;
import majic.link.Links;
import majic.time.TimeSource;
import majicsim.Lab;
import majicsim.LabOptions;
import majicsim.world.Point;
import org.jspecify.annotations.Nullable;

/** A simulated lab inside this program: its simulators, and the clock that their robots' drivers share with them. */
public final class SimulatedLab implements LabAccess, AutoCloseable {
    /** The number that distinguishes a further robot of a type from the first: {@code pioneer2}. */
    private static final Pattern COUNT = Pattern.compile("\\d+$");

    /** Their addresses are a scheme and a server, {@code ros://host:port}; those of the others name the link too. */
    private static final Set<String> SCHEMES = Set.of("ros", "mavlink");

    /** What may follow the port in the address of a ROS robot. */
    private static final Pattern NAMESPACE = Pattern.compile("(?<=:\\d{1,5})/.*");

    private final Lab lab;
    private final long seed;
    private final LabClock clock;
    private final List<Wall> walls;
    private final Furnishing furnishing;
    private @Nullable String tooSlow;
    private @Nullable Consumer<String> tooSlowListener;

    private SimulatedLab(Lab lab, long seed, Function<Consumer<String>, Pacing> pacing) {
        this.lab = lab;
        this.seed = seed;
        this.clock = new LabClock(Lab.STEP_NANOS, () -> step(lab), pacing.apply(this::tooSlow));
        this.walls = lab.walls().stream()
                .map(wall -> new Wall(wall.x1(), wall.y1(), wall.x2(), wall.y2()))
                .toList();
        this.furnishing = furnishing(lab);
    }

    private static void step(Lab lab) {
        try {
            lab.step();
        } catch (RuntimeException | Error e) {
            lab.close();
            throw e;
        }
    }

    /**
     * Opens a lab whose clock follows the wall clock. At most 0.1 s of its time passes before drivers in this program
     * have handled what it sent, except at real time and below.
     *
     * @param options the options of the lab
     * @param speed how many times as fast; a computer that is too slow runs it at a lower speed
     * @return the running lab
     * @throws IOException if a port is taken or the room does not hold the robots
     */
    public static SimulatedLab scaled(LabOptions options, double speed) throws IOException {
        Lab lab = open(options);
        return started(lab, options.seed(), tooSlow -> Pacing.scaled(speed, transit(lab), tooSlow));
    }

    /**
     * Opens a lab whose clock advances as soon as all its members wait.
     *
     * @param options the options of the lab
     * @return the running lab
     * @throws IOException if a port is taken or the room does not hold the robots
     */
    public static SimulatedLab stepped(LabOptions options) throws IOException {
        Lab lab = open(options);
        return started(lab, options.seed(), tooSlow -> Pacing.stepped(transit(lab)));
    }

    /** Without native code the lab has no pseudo-terminals. */
    private static Lab open(LabOptions options) throws IOException {
        try {
            NativeFolder.prepare();
        } catch (IOException e) {
            System.getLogger(SimulatedLab.class.getName()).log(Level.INFO, e.getMessage());
        }
        return Lab.open(options);
    }

    private static TransitCheck transit(Lab lab) {
        Set<String> ports = lab.addresses().values().stream()
                .map(address -> NAMESPACE.matcher(address).replaceFirst(""))
                .collect(Collectors.toSet());
        return new TransitCheck(Links::traffic, lab::lines, ports);
    }

    private static SimulatedLab started(Lab lab, long seed, Function<Consumer<String>, Pacing> pacing) {
        SimulatedLab simulated = new SimulatedLab(lab, seed, pacing);
        simulated.clock.start();
        return simulated;
    }

    /**
     * Sets what is informed when the lab does not reach its speed, which happens once at most.
     *
     * @param listener receives a sentence, on the clock's thread; at once if it was reported before
     */
    public synchronized void onTooSlow(Consumer<String> listener) {
        tooSlowListener = listener;
        reportTooSlow();
    }

    private synchronized void tooSlow(String sentence) {
        tooSlow = sentence;
        reportTooSlow();
    }

    private void reportTooSlow() {
        if (tooSlowListener != null && tooSlow != null) {
            tooSlowListener.accept(tooSlow);
        }
    }

    @Override
    public long seed() {
        return seed;
    }

    /** Returns the simulators themselves, for functions that only a lab has: faults, positions. */
    public Lab simulators() {
        return lab;
    }

    @Override
    public List<String> robots() {
        return List.copyOf(lab.truePoses().keySet());
    }

    @Override
    public Optional<BotAddress> address(String robot) {
        String type = COUNT.matcher(robot).replaceFirst("");
        String prefix = SCHEMES.contains(type) ? "//" : "tcp://";
        return Optional.ofNullable(lab.addresses().get(robot)).map(where -> new BotAddress(type, prefix + where));
    }

    @Override
    public TimeSource time() {
        return clock;
    }

    @Override
    public Map<String, Pose> truePoses() {
        Map<String, Pose> poses = new LinkedHashMap<>();
        lab.truePoses().forEach((name, at) -> poses.put(name, new Pose(at.xMm(), at.yMm(), at.headingDeg())));
        return poses;
    }

    @Override
    public Map<String, Integer> bumps() {
        return lab.bumps();
    }

    @Override
    public void place(String robot, Pose pose) {
        if (!robots().contains(robot)) {
            throw new BotException("the lab has no " + robot);
        }
        if (!lab.room().bounds().contains(pose.xMm(), pose.yMm())) {
            throw new BotException("that is outside the room");
        }
        try {
            lab.place(robot, new majicsim.world.Pose(pose.xMm(), pose.yMm(), pose.headingDeg()));
        } catch (IllegalArgumentException e) {
            throw new BotException("a wall or another robot is there", e);
        }
    }

    @Override
    public List<Wall> walls() {
        return walls;
    }

    @Override
    public Furnishing furnishing() {
        return furnishing;
    }

    private static Furnishing furnishing(Lab lab) {
        List<Tape> tapes =
                lab.room().tapes().stream().flatMap(SimulatedLab::pieces).toList();
        List<Lamp> lamps = lab.room().lamps().stream()
                .map(lamp -> new Lamp(lamp.at().xMm(), lamp.at().yMm()))
                .toList();
        return new Furnishing(tapes, lamps);
    }

    private static Stream<Tape> pieces(majicsim.world.Tape stripe) {
        List<Point> points = stripe.points();
        return IntStream.range(1, points.size()).mapToObj(index -> {
            Point from = points.get(index - 1);
            Point to = points.get(index);
            return new Tape(from.xMm(), from.yMm(), to.xMm(), to.yMm());
        });
    }

    @Override
    public void close() {
        clock.close();
        lab.close();
    }
}
