package majic.gui.bots;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.Window;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.util.List;
import javax.swing.JFrame;
import javax.swing.JPanel;
import majic.gui.drive.DrivePad;
import majic.gui.drive.GuardChoice;
import majic.gui.kit.CloseKey;
import majic.gui.kit.HelpTopic;
import majic.panel.PictureView;
import majic.panel.PictureViewer;
import majic.team.Member;
import majic.text.Texts;
import net.miginfocom.swing.MigLayout;
import org.jspecify.annotations.Nullable;

/** A window with the panel of one robot, a pad that drives this robot, and a STOP button for all robots. */
final class PanelWindow extends JFrame implements PictureViewer {
    private static final long serialVersionUID = 1L;
    private static final Texts TEXTS = Texts.of(PanelWindow.class);
    private static final int PAD_HEIGHT = 90;

    private final transient Member member;
    private final DrivePad pad;
    private final @Nullable Window main;

    /**
     * Creates the window around a panel; takes the panel from where it is.
     *
     * @param guard whether the robot is guarded when it is driven by hand
     * @param main the main window; null without one
     * @param place where the panel was, on the screen
     * @param closed runs when the user closes the window
     */
    PanelWindow(
            BotPanel panel,
            RobotActions actions,
            GuardChoice guard,
            @Nullable Window main,
            Point place,
            Runnable closed) {
        HelpTopic.set(getRootPane(), "selecting-robots");
        CloseKey.install(this);
        this.main = main;
        member = panel.member();
        setName("robotWindow" + member.number());
        setDefaultCloseOperation(DO_NOTHING_ON_CLOSE);
        Dimension size = panel.getSize();
        pad = new DrivePad("-window" + member.number(), guard, actions::showError);
        pad.choose(List.of(member));
        add(panel, BorderLayout.CENTER);
        JPanel below = new JPanel(new MigLayout("insets 0 0 0 10, gap 0", "[grow, fill][]"));
        below.add(pad, "wmin 0");
        below.add(actions.stopButton(), "aligny center");
        add(below, BorderLayout.SOUTH);
        if (main != null) {
            setIconImages(main.getIconImages());
        }
        pack();
        setSize(Math.max(getWidth(), size.width), Math.max(getHeight(), size.height + PAD_HEIGHT));
        Rectangle screen = getGraphicsConfiguration().getBounds();
        setLocation(
                Math.max(screen.x, Math.min(place.x, screen.x + screen.width - getWidth())),
                Math.max(screen.y, Math.min(place.y, screen.y + screen.height - getHeight())));
        update();
        addWindowListener(new WindowAdapter() {
            @Override
            public void windowClosing(WindowEvent event) {
                closed.run();
            }
        });
    }

    /** Passes the picture on to the main window. */
    @Override
    public void enlarge(PictureView view) {
        if (main instanceof PictureViewer viewer) {
            viewer.enlarge(view);
        }
    }

    /** Shows the name of the robot, and whether it can be driven. */
    void update() {
        setTitle(TEXTS.get("window.title", member.number(), StatusStrip.title(member)));
        pad.update();
    }
}
