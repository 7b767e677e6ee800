package majic.gui.replay;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Dimension;
import java.awt.Frame;
import java.awt.GraphicsEnvironment;
import java.awt.Rectangle;
import java.awt.Window;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.nio.file.Path;
import java.util.function.Consumer;
import javax.swing.JFrame;
import javax.swing.WindowConstants;
import majic.gui.kit.ClearOfStop;
import majic.gui.kit.CloseKey;
import majic.gui.kit.EventThread;
import majic.gui.kit.HelpTopic;
import majic.gui.kit.PictureDialog;
import majic.gui.plot.Plots;
import majic.gui.plot.data.RecordedSource;
import majic.panel.PictureView;
import majic.panel.PictureViewer;
import majic.text.Texts;

/**
 * Replays a recording, one of its parts after the other, with the plots of it. Must be used on the event dispatch
 * thread.
 */
public final class ReplayWindow extends JFrame implements PictureViewer {
    private static final long serialVersionUID = 1L;
    private static final Texts TEXTS = Texts.of(ReplayWindow.class);

    private final transient ReplayServices services;
    private final transient RecordedSource source;
    private final transient Plots plots;
    private volatile ReplayView view;
    private boolean turning;

    private ReplayWindow(ReplayPart part, ReplayServices services) {
        super(TEXTS.get("title", part.title()));
        HelpTopic.set(getRootPane(), "replaying-a-recording");
        CloseKey.install(this);
        this.services = services;
        source = new RecordedSource(part.recording(), this::position);
        plots = new Plots(this, services.settings(), () -> source, services.stopButtons());
        view = new ReplayView(part, services, plots, this::turnTo);
        setName("replay");
        place();
    }

    /**
     * Reads a file in the background and opens its window, paused at the beginning.
     *
     * @param owner the window beside which it opens
     * @param file a file of a recording
     * @param services what a replay needs
     * @param opened called on the event dispatch thread when the window is shown
     * @param failed receives the reason if the file cannot be read, as a sentence, on the event dispatch thread
     */
    public static void open(
            Window owner, Path file, ReplayServices services, Runnable opened, Consumer<String> failed) {
        EventThread.background(
                "opening " + file.getFileName(),
                () -> {
                    ReplayPart part = ReplayPart.read(file);
                    EventThread.later(() -> {
                        show(owner, part, services);
                        opened.run();
                    });
                },
                failed);
    }

    private static void show(Window owner, ReplayPart part, ReplayServices services) {
        ReplayWindow window = new ReplayWindow(part, services);
        if (owner instanceof Frame frame) {
            window.setIconImages(frame.getIconImages());
        }
        window.setLocationRelativeTo(owner);
        ClearOfStop.place(window, owner);
        window.setVisible(true);
        window.view.start();
    }

    private void place() {
        setContentPane(view);
        setDefaultCloseOperation(WindowConstants.DISPOSE_ON_CLOSE);
        setMinimumSize(new Dimension(700, 520));
        Rectangle screen = GraphicsEnvironment.getLocalGraphicsEnvironment().getMaximumWindowBounds();
        setSize(Math.min(UIScale.scale(1200), screen.width), Math.min(UIScale.scale(780), screen.height));
        addWindowListener(new WindowAdapter() {
            @Override
            public void windowOpened(WindowEvent event) {
                view.first().requestFocusInWindow();
            }
        });
    }

    private double position() {
        return view.position();
    }

    /** Reads another part in the background, and shows it in place of the present one. */
    private void turnTo(Path file, boolean playing) {
        if (turning) {
            return;
        }
        turning = true;
        view.setTurning(true);
        EventThread.background(
                "opening " + file.getFileName(),
                () -> {
                    ReplayPart part = ReplayPart.read(file);
                    source.show(part.recording());
                    EventThread.later(() -> turned(part, playing));
                },
                reason -> {
                    turning = false;
                    view.showProblem(reason);
                });
    }

    private void turned(ReplayPart part, boolean playing) {
        turning = false;
        if (!isDisplayable()) {
            return;
        }
        ReplayView before = view;
        view = new ReplayView(part, services, plots, this::turnTo);
        setTitle(TEXTS.get("title", part.title()));
        setContentPane(view);
        view.continueAs(before, playing);
        before.close();
        validate();
        view.first().requestFocusInWindow();
        view.start();
    }

    @Override
    public void enlarge(PictureView picture) {
        new PictureDialog(this, picture, services.settings()).setVisible(true);
    }

    /** Ends the replay. */
    @Override
    public void dispose() {
        plots.close();
        view.close();
        super.dispose();
    }
}
