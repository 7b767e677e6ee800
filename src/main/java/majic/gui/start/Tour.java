package majic.gui.start;

import java.awt.GraphicsConfiguration;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.Window;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JProgressBar;
import javax.swing.Timer;
import majic.gui.kit.EventThread;
import majic.gui.kit.HelpTopic;
import majic.gui.kit.MajicDialog;
import majic.gui.kit.NamedLabel;
import majic.gui.kit.Paragraph;
import majic.script.Session;
import majic.text.Texts;
import net.miginfocom.swing.MigLayout;

/**
 * The tour: a small window beside the main window that asks for one thing after the other, to be done in the main
 * window with the robots of the lab. It waits until each is done, and can be closed at any time.
 */
public final class Tour extends MajicDialog {
    private static final long serialVersionUID = 1L;
    private static final Texts TEXTS = Texts.of(Tour.class);
    private static final int LOOK_MS = 200;

    /** The share of the width of the window to the left of the tabs. */
    private static final double MAP_SHARE = 0.36;

    private static final int COMMAND_LINE_PX = 90;

    private final transient TourEvents events;
    private final JLabel count = new NamedLabel("tourCount", "");
    private final JLabel title = new NamedLabel("tourTitle", "");
    private final Paragraph text = new Paragraph("tourText", 9, 30);
    private final JLabel state = new NamedLabel("tourState", "");
    private final JProgressBar progress = new JProgressBar(0, TourStep.ALL.size());
    private final JButton next = button(TEXTS.get("next"), this::next);
    private final JButton skip = button(TEXTS.get("skip"), this::next);
    private final JButton close = closing(TEXTS.get("close"));
    private final Timer look = new Timer(LOOK_MS, event -> look());
    private int step = -1;
    private boolean done;

    /**
     * Creates the tour at its first step, not yet shown.
     *
     * @param owner the main window
     */
    public Tour(Window owner, Session session) {
        super(owner, TEXTS.get("tour.title"));
        HelpTopic.set(getRootPane(), "the-start-page");
        events = new TourEvents(session);
        title.putClientProperty("FlatLaf.styleClass", "h3");
        text.setFocusable(true);
        fill(content(), next, skip, close);
        getAccessibleContext().setAccessibleDescription(TEXTS.get("tour.description"));
        next();
        placeBeside(owner);
        look.start();
    }

    private JPanel content() {
        JPanel panel = new JPanel(new MigLayout("insets 0, gap 6 6, wrap 1", "[340, fill]", "[][][][grow, fill][]"));
        progress.getAccessibleContext().setAccessibleName(TEXTS.get("steps"));
        panel.add(count, "split 2, growx 0");
        panel.add(progress, "h 6!, gapleft 10");
        panel.add(title);
        panel.add(text, "wmin 0");
        panel.add(state);
        return panel;
    }

    private void next() {
        step++;
        done = false;
        events.begin();
        progress.setValue(step);
        if (step >= TourStep.ALL.size()) {
            end();
            return;
        }
        count.setText(TEXTS.get("step", step + 1, TourStep.ALL.size()));
        title.setText(TEXTS.get(TourStep.ALL.get(step).title()));
        look();
    }

    private void end() {
        look.stop();
        count.setText(TEXTS.get("end"));
        title.setText(TEXTS.get("end.title"));
        text.show(TEXTS.get("end.text"), false);
        state.setText(" ");
        next.setVisible(false);
        skip.setVisible(false);
        getRootPane().setDefaultButton(close);
    }

    /** Shows whether the step was done. */
    private void look() {
        TourStep now = TourStep.ALL.get(step);
        done |= now.done().test(events);
        String wanted = TEXTS.get(now.text(), events.robotNumber());
        if (!wanted.equals(text.getText())) {
            text.show(wanted, false);
        }
        state.setText(TEXTS.get(done ? "done" : "waiting"));
        next.setEnabled(done);
        skip.setEnabled(!done);
    }

    /**
     * Places the tour beside the window where the screen has room, otherwise over the map, where it hides neither tabs
     * nor pad.
     */
    private void placeBeside(Window owner) {
        GraphicsConfiguration screen = owner.getGraphicsConfiguration();
        if (screen == null) {
            return;
        }
        Rectangle area = screen.getBounds();
        Rectangle main = owner.getBounds();
        int right = main.x + main.width;
        if (right + getWidth() <= area.x + area.width) {
            setLocation(new Point(right, main.y));
        } else if (main.x - getWidth() >= area.x) {
            setLocation(new Point(main.x - getWidth(), main.y));
        } else {
            int left = main.x + (int) (main.width * MAP_SHARE) - getWidth();
            int bottom = main.y + main.height - COMMAND_LINE_PX - getHeight();
            setLocation(new Point(Math.max(main.x, left), Math.max(main.y, bottom)));
        }
    }

    /** Ends the tour, in the background because the session waits for its listeners. */
    @Override
    public void dispose() {
        look.stop();
        EventThread.background("ending the tour", events::close);
        super.dispose();
    }
}
