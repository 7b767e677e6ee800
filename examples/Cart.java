import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;
import majic.bot.Beam;
import majic.bot.BotAddress;
import majic.bot.BotException;
import majic.bot.BotProfile;
import majic.bot.BotState;
import majic.bot.BotType;
import majic.bot.ConnectFailed;
import majic.bot.LinkLost;
import majic.bot.MajicBot;
import majic.bot.MotionFailed;
import majic.bot.Pose;
import majic.bot.Range;
import majic.bot.RangeScan;
import majic.bot.RangeSensor;
import majic.bot.Unit;
import majic.bot.Value;
import majic.driver.BotDriver;
import majic.driver.LinkHandler;
import majic.driver.LinkReader;
import majic.driver.Motion;
import majic.environment.BotEnvironment;
import majic.link.Link;
import majic.link.Links;

/**
 * A robot behind a network link: a cart that takes lines such as {@code drive 100 0} (mm/s and deg/s) and reports ten
 * times a second its position in lines such as {@code at 250 0 0} (mm, mm and degrees), and what the sonar at its front
 * measures in lines such as {@code range 1500} (mm).
 */
public final class Cart extends BotDriver {
    private static final int CONNECT_TIMEOUT_MS = 3000;
    private static final double FIRST_REPORT_S = 3;
    private static final double SILENCE_S = 1;

    /** A single beam ahead, 180 mm ahead of the cart's centre: a cone of 20 degrees, 50 to 3000 mm, noise 10 mm. */
    private static final RangeSensor SONAR =
            new RangeSensor("sonar", List.of(new Beam(new Pose(180, 0, 0), 20, 50, 3000, 10)));

    private final String address;
    private volatile Link link;
    private volatile boolean reporting;
    private volatile Pose pose = Pose.START;

    /** Registers the robot type with MAJIC. */
    public static final class Type implements BotType {
        @Override
        public String name() {
            return "cart";
        }

        @Override
        public String label() {
            return "Cart";
        }

        @Override
        public String make() {
            return "Example Cart";
        }

        @Override
        public List<Reach> reaches() {
            return List.of(Reach.TCP);
        }

        @Override
        public int defaultPort(String scheme) {
            return 4000;
        }

        @Override
        public MajicBot create(BotAddress address, BotEnvironment environment) {
            return new Cart(this, address.rest(), environment);
        }

        @Override
        public String advice() {
            return "Switch the cart on and check its address.";
        }
    }

    Cart(BotType type, String address, BotEnvironment environment) {
        super(type, new BotProfile(200, new Range(-1000, 1000), new Range(-180, 180), 100, 45, 100, true), environment);
        this.address = address;
        this.link = newLink();
    }

    private Link newLink() {
        try {
            return Links.of(address, type().defaultPort(type().name()), 0);
        } catch (IllegalArgumentException e) {
            throw new BotException(e.getMessage(), e);
        }
    }

    @Override
    protected void open() {
        Link opening = newLink();
        link = opening;
        reporting = false;
        try {
            opening.open(CONNECT_TIMEOUT_MS);
        } catch (IOException e) {
            throw ConnectFailed.of(e);
        }
        new LinkReader<>(opening, "the cart closed it", new Reports(opening)).start("cart reader");
        awaitFirstReport(opening);
        every("cart silence", SILENCE_S / 4, this::checkSilence);
    }

    private void awaitFirstReport(Link opening) {
        if (!waiting().awaitConnecting(() -> reporting, FIRST_REPORT_S)) {
            opening.close();
            throw new ConnectFailed(
                    ConnectFailed.Reason.NO_ANSWER, "there is no report within " + FIRST_REPORT_S + " s");
        }
    }

    /** A link may stay open without a robot at its other end. */
    private void checkSilence() {
        if (isConnected() && time().secondsSince(state().atNanos()) > SILENCE_S) {
            lost(new LinkLost("no report for 1 s"));
            link.close();
        }
    }

    @Override
    protected void shut() {
        link.close();
    }

    @Override
    public List<RangeSensor> rangeSensors() {
        return List.of(SONAR);
    }

    @Override
    protected Value moveBy(double mm, Motion motion) {
        Pose start = pose;
        if (!motion.pause(0)) {
            return Value.of(0, Unit.MM);
        }
        motion.send(() -> driveAt(Math.signum(mm) * cruiseMmPerSec(), 0));
        double longest = 2 * Math.abs(mm) / cruiseMmPerSec() + 1;
        boolean there = motion.await(() -> pose.distanceMm(start) >= Math.abs(mm), longest);
        motion.send(this::halt);
        double gone = Math.signum(mm) * pose.distanceMm(start);
        if (!there && !motion.guardReached()) {
            throw new MotionFailed("stalled after " + Math.round(gone) + " mm");
        }
        return Value.of(gone, Unit.MM);
    }

    @Override
    protected Value turnBy(double degrees, Motion motion) {
        double degPerSec = Math.signum(degrees) * cruiseTurnDegPerSec();
        double seconds = Math.abs(degrees) / cruiseTurnDegPerSec();
        if (!motion.pause(0)) {
            return Value.about(0, Unit.DEG);
        }
        motion.send(() -> driveAt(0, degPerSec));
        motion.pause(seconds);
        motion.send(this::halt);
        return Value.about(degPerSec * Math.min(seconds, motion.seconds()), Unit.DEG);
    }

    @Override
    protected void driveAt(double mmPerSec, double degPerSec) {
        write(String.format(Locale.ROOT, "drive %.0f %.0f\n", mmPerSec, degPerSec));
        boolean moving = mmPerSec != 0 || degPerSec != 0;
        publish(new BotState(pose, mmPerSec, degPerSec, moving, state().atNanos()));
    }

    @Override
    protected void halt() {
        driveAt(0, 0);
    }

    private void write(String line) {
        try {
            link.write(line.getBytes(StandardCharsets.US_ASCII));
        } catch (IOException e) {
            throw new LinkLost(e.getMessage(), e);
        }
    }

    /** Handles the lines of one link, on its reader thread. */
    private final class Reports implements LinkHandler<String> {
        private final Link from;
        private final StringBuilder line = new StringBuilder();

        Reports(Link from) {
            this.from = from;
        }

        @Override
        public void decode(byte[] bytes, int count, Consumer<String> messages) {
            for (char next : new String(bytes, 0, count, StandardCharsets.US_ASCII).toCharArray()) {
                if (next != '\n') {
                    line.append(next);
                } else {
                    messages.accept(line.toString());
                    line.setLength(0);
                }
            }
        }

        /** An unreadable line throws an exception here; the reader logs it and continues. */
        @Override
        public void received(String message) {
            String[] words = message.split(" ");
            if (words[0].equals("range")) {
                measured(Float.parseFloat(words[1]));
            } else {
                moved(new Pose(
                        Double.parseDouble(words[1]), Double.parseDouble(words[2]), Double.parseDouble(words[3])));
            }
        }

        private void moved(Pose reported) {
            pose = reported;
            reporting = true;
            BotState before = state();
            publish(new BotState(
                    pose, before.speedMmPerSec(), before.turnRateDegPerSec(), before.moving(), time().nanos()));
        }

        private void measured(float mm) {
            if (hasScanListeners()) {
                publishScan(new RangeScan(SONAR, time().nanos() / 1e9, pose, mm));
            }
        }

        /** An old link may end after the robot was connected again by a new one. */
        @Override
        public void ended(IOException cause) {
            from.close();
            if (from == link) {
                lost(new LinkLost(cause.getMessage(), cause));
            }
        }
    }
}
