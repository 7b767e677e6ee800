package majic.aibo;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import javax.swing.JComponent;
import majic.aibo.body.Calibration;
import majic.aibo.body.DogState;
import majic.aibo.body.Gait;
import majic.aibo.body.GaitPiece;
import majic.aibo.body.Paces;
import majic.aibo.body.Stride;
import majic.aibo.panel.AiboPanel;
import majic.aibo.panel.CameraPicture;
import majic.aibo.panel.PanelPoller;
import majic.aibo.parameters.AiboAccess;
import majic.aibo.parameters.AiboParameters;
import majic.aibo.parameters.CalibrationParameters;
import majic.aibo.parameters.RawCommand;
import majic.aibo.session.AiboSession;
import majic.aibo.session.CalibrationRun;
import majic.aibo.session.RunningMotion;
import majic.aibo.sound.PlayCommand;
import majic.aibo.sound.RecordCommand;
import majic.aibo.sound.Speaker;
import majic.aibo.sound.Volume;
import majic.aibo.urbi.UrbiConnection;
import majic.aibo.urbi.UrbiTransport;
import majic.aibo.urbi.UrbiValue;
import majic.aibo.urbi.UrbiVersion;
import majic.bot.BotAddress;
import majic.bot.BotException;
import majic.bot.LinkLost;
import majic.bot.Unit;
import majic.bot.Value;
import majic.driver.BotDriver;
import majic.driver.CalibrateCommand;
import majic.driver.Motion;
import majic.environment.BotEnvironment;
import org.jspecify.annotations.Nullable;

/**
 * A Sony Aibo ERS-7 with URBI 1.0 or 1.5 on its memory stick, over TCP.
 *
 * <p>It walks by timed gaits and has no odometry, so distances, angles and the pose are estimates; four factors in the
 * settings adapt them to the dog. The first motion switches the motors on and stands the dog up. While it walks ahead
 * its head sweeps from side to side: the infra-red beams are much narrower than the dog.
 */
public final class MajicAibo extends BotDriver {
    /** Longer than any sensor is polled for, as far as the dog keeps up, s. */
    private static final double FIRST_READINGS_S = 1;

    private static final double TICK_S = 0.1;

    private final Supplier<UrbiTransport> transports;
    private final DogState dog;
    private final AiboParameters parameters;
    private volatile @Nullable AiboSession session;
    private volatile @Nullable LinkLost lostBecause;

    /**
     * Makes the driver of a dog, without touching it, for a program that needs just a robot.
     *
     * @param address as users type it: {@code aibo://192.168.1.20}, {@code aibo://192.168.1.20:54000}, or
     *     {@code aibo+liburbi://192.168.1.20} to drive it by that library
     * @throws BotException if it is no such address
     */
    public MajicAibo(String address) {
        this(BotAddress.parse(address), BotEnvironment.plain());
    }

    /**
     * Makes the driver of a dog, without touching it.
     *
     * @param address may name a library
     * @param environment its clock and settings
     * @throws BotException if it is no dog's address, or the library is missing; the message says what is right
     */
    public MajicAibo(BotAddress address, BotEnvironment environment) {
        super(new AiboType(), new Paces(calibration(address, environment)).profile(), environment);
        this.dog = new DogState(calibration(address, environment));
        this.transports = AiboTransports.of(address, environment);
        AiboAccess access = new AiboAccess(dog.senses(), waiting(), this::session);
        Volume volume = new Volume();
        this.parameters = new AiboParameters(table(), dog, access, volume);
        parameters.describe(UrbiVersion.V1_0);
        new CalibrationParameters(dog.calibration(), this::learn).describe(table());
        add(CalibrateCommand.of(
                new CalibrationRun(() -> session().walker(), dog.calibration(), this::stride, this::learn)));
        add(new RawCommand(access, dog).command());
        add(new PlayCommand(new Speaker(() -> session().connections().sensors(), volume)).command());
        add(new RecordCommand(() -> session().microphone(), changes()::raise, this::notice).command());
    }

    private static Calibration calibration(BotAddress address, BotEnvironment environment) {
        return new Calibration(environment.settings(), address.rest().replaceFirst("^(tcp:)?//", ""));
    }

    private Stride stride(Gait gait) {
        Paces paces = new Paces(dog.calibration());
        return gait.isWalk()
                ? paces.stride(gait, cruiseMmPerSec(), profile().cruiseMmPerSec())
                : paces.stride(gait, cruiseTurnDegPerSec(), profile().cruiseTurnDegPerSec());
    }

    /** Uses the factor even if it could not be stored. */
    private void learn(Gait gait, double msPerUnit) {
        try {
            dog.calibration().keep(gait, msPerUnit);
        } finally {
            profile(new Paces(dog.calibration()).profile());
        }
    }

    @Override
    protected void open() {
        lostBecause = null;
        AiboSession opening = new AiboSession(transports, waiting(), dog, new SessionEvents());
        session = opening;
        try {
            opening.open();
        } catch (BotException e) {
            session = null;
            throw e;
        }
        parameters.describe(opening.connections().sensors().version());
        every("aibo tick", TICK_S, this::tick);
        long openedNanos = time().nanos();
        waiting().awaitConnecting(() -> state().atNanos() > openedNanos, FIRST_READINGS_S);
    }

    @Override
    protected void shut() {
        AiboSession closing = session;
        session = null;
        if (closing != null) {
            closing.close();
        }
    }

    private void tick() {
        AiboSession open = session;
        if (open != null && isConnected()) {
            open.tick();
        }
    }

    @Override
    protected Value moveBy(double mm, Motion motion) {
        double covered = session().walker().cover(stride(Gait.walking(mm)), Math.abs(mm), motion);
        return Value.about(covered, Unit.MM);
    }

    @Override
    protected Value turnBy(double degrees, Motion motion) {
        double covered = session().walker().cover(stride(Gait.turning(degrees)), Math.abs(degrees), motion);
        return Value.about(covered, Unit.DEG);
    }

    @Override
    protected void driveAt(double mmPerSec, double degPerSec) {
        session().drive().drive(mmPerSec, degPerSec);
    }

    @Override
    protected @Nullable Value driven() {
        session().drive().checkEnded();
        return null;
    }

    @Override
    protected void halt() {
        session().halt();
    }

    @Override
    protected void haltAhead() {
        AiboSession open = session;
        if (open != null) {
            open.haltAhead();
        }
    }

    @Override
    public void confirmHalt() {
        session().executor().confirm();
    }

    @Override
    public List<String> calibration() {
        return Arrays.stream(Gait.values()).map(CalibrationParameters::factor).toList();
    }

    @Override
    public @Nullable JComponent display() {
        return AiboPanel.create(this, dog, shown -> poller(new PublishedPictures(shown))::look);
    }

    @Override
    protected double longestAgeS() {
        return LONGEST_AGE_S;
    }

    @Override
    public Map<String, String> displayState() {
        return dog.texts();
    }

    @Override
    public boolean hasCamera() {
        return true;
    }

    @Override
    public byte[] takePicture() {
        return CameraPicture.take(session().connections().sensors(), waiting());
    }

    /** The readings and the estimated state of the dog. */
    DogState dog() {
        return dog;
    }

    /** Makes the poller of pictures and LEDs, which does not poll yet. */
    PanelPoller poller(PanelPoller.PictureReceiver receiver) {
        return new PanelPoller(waiting(), this::openSensors, this::isBusy, receiver);
    }

    private @Nullable UrbiConnection openSensors() {
        AiboSession open = session;
        return isConnected() && open != null ? open.connections().sensors() : null;
    }

    /**
     * The open session.
     *
     * @throws LinkLost if there is none
     */
    AiboSession session() {
        AiboSession open = session;
        if (open == null) {
            LinkLost cause = lostBecause;
            throw cause == null
                    ? new LinkLost("not connected")
                    : new LinkLost(String.valueOf(cause.getMessage()), cause);
        }
        return open;
    }

    /** Publishes the pictures that the panel receives. */
    private final class PublishedPictures implements PanelPoller.PictureReceiver {
        private final PanelPoller.PictureReceiver shown;

        PublishedPictures(PanelPoller.PictureReceiver shown) {
            this.shown = shown;
        }

        @Override
        public void see(UrbiValue picture, double perSecond) {
            shown.see(picture, perSecond);
            publishPicture(() -> CameraPicture.jpegFile(picture));
        }

        @Override
        public void miss(String why) {
            shown.miss(why);
        }
    }

    /** Passes the session's events on to the listeners, on the session's threads. */
    private final class SessionEvents implements AiboSession.Robot {
        @Override
        public void sensed() {
            AiboSession open = session;
            RunningMotion running = open == null ? null : open.executor().current();
            GaitPiece piece = running == null ? null : running.piece();
            publish(dog.state(piece, running != null));
        }

        @Override
        public void notice(String message) {
            MajicAibo.this.notice(message);
        }

        @Override
        public void lost(LinkLost cause) {
            lostBecause = cause;
            session = null;
            MajicAibo.this.lost(cause);
        }
    }
}
