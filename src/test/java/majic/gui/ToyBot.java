package majic.gui;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import javax.swing.JComponent;
import javax.swing.JLabel;
import majic.bot.BotException;
import majic.bot.BotProfile;
import majic.bot.BotState;
import majic.bot.ConnectFailed;
import majic.bot.LinkLost;
import majic.bot.Parameter;
import majic.bot.Pose;
import majic.bot.Range;
import majic.bot.Unit;
import majic.bot.Value;
import majic.driver.BotDriver;
import majic.driver.Motion;
import majic.environment.BotEnvironment;
import majic.time.WaitLimit;
import org.jspecify.annotations.Nullable;

/** A robot of the window's tests; records the commands it gets. */
public final class ToyBot extends BotDriver {
    public static final double CRUISE = 200;
    public static final double CRUISE_TURN = 40;
    private static final double FULL_CHARGE = 100;

    private static final BotProfile PROFILE =
            new BotProfile(150, new Range(-400, 400), new Range(-90, 90), CRUISE, CRUISE_TURN, 300, false);

    public final List<String> told = new CopyOnWriteArrayList<>();
    public final CountDownLatch closed = new CountDownLatch(1);
    private final ToyType type;
    private final String address;
    private volatile CountDownLatch jam = new CountDownLatch(0);
    private volatile boolean deaf;
    private volatile @Nullable BotException refusal;
    private volatile @Nullable String holder;

    public ToyBot(ToyType type, String address, BotEnvironment environment) {
        super(type, PROFILE, environment);
        this.type = type;
        this.address = address;
        if (address.contains("charged")) {
            table().add(
                            Parameter.number("battery", Unit.PERCENT, "its charge"),
                            () -> Value.of(FULL_CHARGE, Unit.PERCENT));
        }
    }

    /** Reports that a user of another program holds it from now on. */
    public void holdBy(String user) {
        holder = user;
        at(Pose.START, false);
    }

    @Override
    public Optional<String> remoteHolder() {
        return Optional.ofNullable(holder);
    }

    @Override
    protected void open() {
        if (address.contains("silent")) {
            awaitClosing();
        }
        if (address.contains("defective")) {
            throw new NoClassDefFoundError("a class of the driver");
        }
        if (address.contains("strict") && !type.isUnlocked()) {
            throw new ConnectFailed(
                    ConnectFailed.Reason.WRONG_LOGIN, "the broker refuses the user name or the password");
        }
        BotException problem = refusal;
        if (problem != null) {
            throw problem;
        }
        if (address.contains("absent")) {
            throw new BotException("nothing answers at " + address);
        }
        at(Pose.START, false);
    }

    private void awaitClosing() {
        try {
            if (!closed.await(WaitLimit.SECONDS, TimeUnit.SECONDS)) {
                throw new BotException("the test forgot to close this robot");
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
        throw new BotException("closed while connecting");
    }

    /** Reports a pose. */
    public void at(Pose pose, boolean moving) {
        publish(new BotState(pose, moving ? CRUISE : 0, 0, moving, time().nanos()));
    }

    /** Makes every further attempt to connect fail. */
    public void refuseConnections() {
        refuseConnections(new BotException("nothing answers at " + address));
    }

    /** Makes every further attempt to connect fail for a reason. */
    public void refuseConnections(BotException reason) {
        refusal = reason;
    }

    public void loseLink() {
        lost(new LinkLost("connection lost: the cable is out"));
    }

    @Override
    protected void shut() {
        told.add("shut");
        closed.countDown();
    }

    @Override
    protected Value moveBy(double mm, Motion motion) {
        told.add("move " + Value.plain(mm));
        return amount(mm, motion);
    }

    @Override
    protected Value turnBy(double degrees, Motion motion) {
        told.add("turn " + Value.plain(degrees));
        return amount(degrees, motion);
    }

    private Value amount(double number, Motion motion) {
        motion.check();
        if (address.contains("blocked")) {
            throw new BotException("something is in the way");
        }
        return Value.of(number, Unit.NONE);
    }

    @Override
    protected void driveAt(double mmPerSec, double degPerSec) {
        told.add("drive " + Value.plain(mmPerSec) + " " + Value.plain(degPerSec));
    }

    @Override
    protected void haltAhead() {
        try {
            jam.await();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    @Override
    protected void halt() {
        told.add("halt");
    }

    /** Makes every stop block until a latch is released. */
    public void jam(CountDownLatch until) {
        jam = until;
    }

    /** Chooses whether the robot confirms its stops. */
    public void confirmStops(boolean confirms) {
        deaf = !confirms;
    }

    @Override
    public void confirmHalt() {
        if (deaf) {
            throw new BotException("takes no more data");
        }
    }

    @Override
    public @Nullable JComponent display() {
        if (address.contains("incomplete")) {
            throw new NoClassDefFoundError("a class of the panel");
        }
        return address.contains("plain") ? null : new JLabel("the display of " + address);
    }
}
