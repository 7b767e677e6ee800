package majic.figures;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.OptionalInt;
import java.util.OptionalLong;
import java.util.concurrent.ExecutionException;
import java.util.function.BooleanSupplier;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import majic.bot.BotControl;
import majic.bot.BotException;
import majic.bot.BotType;
import majic.bot.MajicBot;
import majic.environment.Settings;
import majic.shared.SharedType;
import majic.shared.broker.BrokerAddress;
import majic.shared.broker.BrokerMessage;
import majic.shared.broker.Quality;
import majic.shared.desk.SiteLatch;
import majic.shared.message.Request;
import majic.shared.message.RequestedAction;
import majic.shared.message.Sender;
import majic.shared.message.SiteTopics;
import majic.shared.message.SpeedMessage;
import majic.team.BotFactory;
import majic.team.Member;
import majic.team.QueuedCommand;
import majic.team.Team;
import majic.time.TimeSource;

/**
 * A program with many desks that share robots, and one that uses some of them over the broker. Measures what all desks
 * use while nothing is commanded, the times from a command at the using desk until the system of the robot's desk has
 * its bytes and until they are read at the robot's end of the link, those of bare messages of the same size meanwhile,
 * and the time from STOP until every desk has stopped all its robots.
 */
final class SharedLoad {
    private static final int MOST_USED = 20;
    private static final int SETTLING_MS = 5000;
    private static final int MEASURED_MS = 10_000;
    /** Enough for the slowest of a hundred to be more than one command. */
    private static final int REQUESTS = 300;

    private static final int DRIVES = 1000;

    /** Commands at the beginning, before Java has compiled their code. */
    private static final int FIRST = 30;

    /** So many commands warm up: with the options of the launcher, Java compiles a method after 200 calls. */
    private static final int WARMING_UP = 300;

    private static final int STOPS = 10;
    private static final int BETWEEN_MS = 20;
    private static final int MOST_WAIT_MS = 3000;

    /** A part that takes longer, because the computer is too slow for so many robots, ends with what it has. */
    private static final double LONGEST_PART_S = 60;

    private static final long LONGEST_ROW_MS = 600_000;

    /** An RVEL packet with a negative rate, without its amount. */
    private static final String RIGHT = "\u00FA\u00FB\u0006\u0015\u001B";

    private static final String LEFT = "\u00FA\u00FB\u0006\u0015\u003B\n";
    private static final String STOP = "\u00FA\u00FB\u0003\u001D\0\u001D";
    private static final double DRIVE_DEG_PER_SEC = 10;

    private static final Sender BARE = Sender.ofThisRun("bare", "figures");
    private static final long NUMBER = 1000;
    private static final long CLOCK_MS = 100_000;

    private final BrokerAddress broker;
    private final SharedDesks desks;
    private final List<RecordedPioneer> recorded;
    private final Team team = new Team(TimeSource.system(), Team.MOST_BOTS);
    private final BrokerBytes bytes;
    private String kindsOfThreads = "";

    private SharedLoad(BrokerAddress broker, SharedDesks desks, List<RecordedPioneer> recorded) {
        this.broker = broker;
        this.desks = desks;
        this.recorded = recorded;
        this.bytes = new BrokerBytes(broker);
    }

    /**
     * Measures, prints one line of figures and one line with the processor time of its threads, and ends.
     *
     * @param arguments the broker's address, its process, the number of desks, the processes of the robots, the
     *     addresses of the robots
     */
    public static void main(String[] arguments) {
        BrokerAddress broker = BrokerAddress.parse(arguments[0]);
        long brokerPid = Long.parseLong(arguments[1]);
        int count = Integer.parseInt(arguments[2]);
        List<Long> labPids =
                Arrays.stream(arguments[3].split(",")).map(Long::valueOf).toList();
        List<String> robots = new ArrayList<>(List.of(arguments).subList(4, arguments.length));
        endAfterLongestRow();
        Measurement.run(() -> {
            try {
                List<RecordedPioneer> recorded = record(robots, count);
                SharedLoad load =
                        new SharedLoad(broker, SharedDesks.share(broker, count, drivers(recorded, robots)), recorded);
                return List.of(load.measure(count, robots.size(), brokerPid, labPids), load.connected());
            } catch (BotException | ExecutionException e) {
                return List.of("the computer is too slow for these robots: " + e.getMessage());
            }
        });
    }

    /** Ends this program with a sentence if it hangs on a computer that is too slow. */
    private static void endAfterLongestRow() {
        Thread limit = new Thread(() -> {
            try {
                Thread.sleep(LONGEST_ROW_MS);
            } catch (InterruptedException e) {
                return;
            }
            System.out.println("the computer is too slow for these robots: no figures after 10 minutes");
            System.out.flush();
            Runtime.getRuntime().halt(1);
        });
        limit.setDaemon(true);
        limit.start();
    }

    /** Returns how many robots are still connected, and what the threads of the desks have used. */
    private String connected() {
        List<Member> all =
                desks.teams().stream().flatMap(one -> one.members().stream()).toList();
        long connected = all.stream()
                .filter(one -> one.bot().connection() == MajicBot.Connection.CONNECTED)
                .count();
        return connected + " of " + all.size() + " robots connected at the end; CPU of the desks: " + kindsOfThreads;
    }

    /** Records the robots that will be used, and one robot of each desk. */
    private static List<RecordedPioneer> record(List<String> robots, int desks) throws IOException {
        List<RecordedPioneer> recorded = new ArrayList<>();
        for (int robot = 0; robot < Math.min(Math.max(MOST_USED, desks), robots.size()); robot++) {
            recorded.add(RecordedPioneer.at(Integer.parseInt(robots.get(robot).replaceFirst(".*:", ""))));
        }
        return recorded;
    }

    private static List<MajicBot> drivers(List<RecordedPioneer> recorded, List<String> robots) {
        BotFactory factory = new BotFactory(BotFactory.types(SharedLoad.class.getClassLoader()), Settings.inMemory());
        return Stream.concat(
                        recorded.stream().map(RecordedPioneer::driver),
                        robots.subList(recorded.size(), robots.size()).stream().map(factory::create))
                .toList();
    }

    /** Returns the figures in the order of the columns of {@link SharedTable}. */
    private String measure(int count, int robots, long brokerPid, List<Long> labPids) throws Exception {
        use();
        Thread.sleep(SETTLING_MS);
        double[] idle = idle(brokerPid, labPids, robots);
        double[] requests = commands(likeRequest(), REQUESTS, this::requests);
        double[] drives = commands(likeSpeed(), DRIVES, this::drives);
        double[] stops = stops();
        return DoubleStream.of(count, robots)
                .boxed()
                .collect(Collectors.collectingAndThen(
                        Collectors.toList(), first -> joined(first, idle, requests, drives, stops)));
    }

    private static String joined(List<Double> first, double[]... rest) {
        List<Double> all = new ArrayList<>(first);
        Arrays.stream(rest).flatMapToDouble(Arrays::stream).forEach(all::add);
        return all.stream().map(String::valueOf).collect(Collectors.joining(" "));
    }

    /** Adds shared robots to the team of the using desk. */
    private void use() {
        team.addListener(new FirstFailure());
        List<BotType> types = BotFactory.types(SharedLoad.class.getClassLoader());
        types.stream()
                .filter(SharedType.class::isInstance)
                .map(SharedType.class::cast)
                .forEach(type -> type.observeSites(
                        (connection, address, by) -> new SiteLatch(team, connection, address.site(), by)));
        BotFactory factory = new BotFactory(types, Settings.inMemory());
        for (int robot = 0; robot < Math.min(MOST_USED, recorded.size()); robot++) {
            MajicBot bot = factory.create(desks.address(robot));
            bot.connect();
            team.add(bot, OptionalInt.empty());
        }
    }

    /**
     * Returns the processor time of all desks, of the broker and of the robots, and the bytes of each robot and second.
     */
    private double[] idle(long brokerPid, List<Long> labPids, int robots) throws InterruptedException {
        ProcessTimes broker = ProcessTimes.of(List.of(brokerPid));
        ProcessTimes labs = ProcessTimes.of(labPids);
        long in = bytes.received();
        long out = bytes.sent();
        ThreadLoads threads = new ThreadLoads();
        ProcessSample before = ProcessSample.now();
        Thread.sleep(MEASURED_MS);
        double percent = ProcessSample.now().percentSince(before);
        double seconds = (System.nanoTime() - before.nanos()) / 1e9;
        kindsOfThreads = new ThreadLoads().byKindSince(threads);
        return new double[] {
            percent,
            broker.percent(),
            labs.percent(),
            (bytes.received() - in) / seconds / robots,
            (bytes.sent() - out) / seconds / robots
        };
    }

    private interface Commands {
        List<RecordedPioneer.Sample> give(BareMessages bare, int count) throws InterruptedException;
    }

    /**
     * Returns the median of the first commands until their bytes arrived, median and 99 of 100 of those after the
     * warm-up until their bytes were written, the same until they arrived, then of the bare messages beside them, and
     * how many did not arrive.
     */
    private double[] commands(BrokerMessage like, int count, Commands commands) throws InterruptedException {
        try (BareMessages bare = new BareMessages(broker, like)) {
            List<Double> warmingUp = times(commands.give(bare, WARMING_UP), RecordedPioneer.Sample::untilArrived);
            bare.reset();
            List<RecordedPioneer.Sample> samples = commands.give(bare, count);
            List<Double> written = times(samples, RecordedPioneer.Sample::untilWritten);
            List<Double> arrived = times(samples, RecordedPioneer.Sample::untilArrived);
            return new double[] {
                within(warmingUp.subList(0, Math.min(FIRST, warmingUp.size())), 0.5),
                within(written, 0.5),
                within(written, 0.99),
                within(arrived, 0.5),
                within(arrived, 0.99),
                within(bare.times(), 0.5),
                within(bare.times(), 0.99),
                samples.size() - arrived.size()
            };
        }
    }

    /** Returns a message like the request for a turn. */
    private BrokerMessage likeRequest() {
        RequestedAction turn = new RequestedAction.Turn(-2, "");
        Request request = new Request(BARE, NUMBER, OptionalLong.of(CLOCK_MS), turn);
        return like(SiteTopics.Part.REQUEST, request.toJson(), Quality.AT_LEAST_ONCE, String.valueOf(NUMBER))
                .expiringAfter(2);
    }

    private BrokerMessage likeSpeed() {
        SpeedMessage speed = new SpeedMessage(BARE, NUMBER, 0, -DRIVE_DEG_PER_SEC, CLOCK_MS);
        return like(SiteTopics.Part.SPEED, speed.toJson(), Quality.AT_MOST_ONCE, "drive-" + NUMBER);
    }

    /** No desk has the topic: its robot has the number 0. */
    private BrokerMessage like(SiteTopics.Part part, byte[] json, Quality quality, String correlation) {
        SiteTopics topics = new SiteTopics(broker.site());
        return BrokerMessage.json(topics.robot("bare1", 0, part), json, quality)
                .answeredAt(topics.replies(BARE.session()), correlation.getBytes(StandardCharsets.UTF_8));
    }

    private static List<Double> times(
            List<RecordedPioneer.Sample> samples, Function<RecordedPioneer.Sample, OptionalLong> until) {
        return samples.stream()
                .map(until)
                .filter(OptionalLong::isPresent)
                .map(nanos -> nanos.getAsLong() / 1e6)
                .toList();
    }

    private List<RecordedPioneer.Sample> requests(BareMessages bare, int count) throws InterruptedException {
        List<RecordedPioneer.Sample> samples = new ArrayList<>();
        long began = System.nanoTime();
        while (samples.size() < count && isInTime(began)) {
            for (int robot = 0; robot < used(); robot++) {
                bare.send();
                Thread.sleep(BETWEEN_MS);
                samples.add(give(robot, RIGHT, control -> control.turn(-2)));
                Thread.sleep(BETWEEN_MS);
            }
            await(() -> team.members().stream().allMatch(Member::isIdle));
        }
        return samples;
    }

    private List<RecordedPioneer.Sample> drives(BareMessages bare, int count) throws InterruptedException {
        List<RecordedPioneer.Sample> samples = new ArrayList<>();
        for (int number = 0; number < count; number++) {
            boolean left = number / used() % 2 == 0;
            double rate = left ? DRIVE_DEG_PER_SEC : -DRIVE_DEG_PER_SEC;
            bare.send();
            Thread.sleep(BETWEEN_MS / 2);
            samples.add(give(number % used(), left ? LEFT : RIGHT, control -> control.drive(0, rate)));
            Thread.sleep(BETWEEN_MS / 2);
        }
        team.stop(team.members(), null);
        await(() -> team.members().stream().noneMatch(Member::isStopping));
        return samples;
    }

    /** Something that a robot is made to do. */
    private interface Deed {
        void run(BotControl control);
    }

    private RecordedPioneer.Sample give(int robot, String packet, Deed deed) {
        RecordedPioneer.Sample sample = recorded.get(robot).begin(packet);
        team.members()
                .get(robot)
                .submit(
                        new QueuedCommand("figure", true, control -> {
                            deed.run(control);
                            return List.of();
                        }),
                        null);
        return sample;
    }

    /**
     * Returns the times from STOP to its bytes at the used robots, then at one robot of each desk: median, 99 of 100;
     * and how many did not arrive.
     */
    private double[] stops() throws InterruptedException {
        List<Double> used = new ArrayList<>();
        List<Double> all = new ArrayList<>();
        long partNanos = System.nanoTime();
        int rounds = 0;
        for (int round = 0; round <= STOPS && isInTime(partNanos); round++) {
            rounds = round;
            List<Integer> before =
                    recorded.stream().map(RecordedPioneer::arrivedBytes).toList();
            long began = System.nanoTime();
            team.stopAll();
            await(() -> arrivals(before).stream().allMatch(OptionalLong::isPresent));
            List<OptionalLong> arrivals = arrivals(before);
            if (round > 0) {
                arrivals.forEach(nanos -> nanos.ifPresent(at -> all.add((at - began) / 1e6)));
                arrivals.subList(0, used()).forEach(nanos -> nanos.ifPresent(at -> used.add((at - began) / 1e6)));
            }
            await(() -> team.areStopsAnswered() && team.members().stream().noneMatch(Member::isStopping));
            await(() -> desks.teams().stream().allMatch(Team::isLatched));
            team.release();
            await(() -> desks.teams().stream().noneMatch(Team::isLatched));
        }
        return new double[] {
            within(used, 0.5),
            within(used, 0.99),
            within(all, 0.5),
            within(all, 0.99),
            rounds * recorded.size() - all.size()
        };
    }

    /** Returns how many robots the using desk has: the first ones. */
    private int used() {
        return team.members().size();
    }

    private List<OptionalLong> arrivals(List<Integer> before) {
        return IntStream.range(0, recorded.size())
                .mapToObj(robot -> recorded.get(robot).arrivalNanos(STOP, before.get(robot)))
                .toList();
    }

    private static boolean isInTime(long beganNanos) {
        return (System.nanoTime() - beganNanos) / 1e9 < LONGEST_PART_S;
    }

    private static void await(BooleanSupplier condition) throws InterruptedException {
        long began = System.nanoTime();
        while (!condition.getAsBoolean() && (System.nanoTime() - began) / 1e6 < MOST_WAIT_MS) {
            Thread.sleep(1);
        }
    }

    private static double within(List<Double> times, double share) {
        List<Double> sorted = times.stream().sorted().toList();
        return sorted.isEmpty() ? Double.NaN : sorted.get((int) Math.min(sorted.size() - 1, sorted.size() * share));
    }
}
