package majic.gui.drive;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Dimension;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.awt.event.HierarchyEvent;
import java.awt.event.KeyAdapter;
import java.awt.event.KeyEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JCheckBox;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JSlider;
import javax.swing.SwingUtilities;
import javax.swing.UIManager;
import majic.gui.kit.HelpTopic;
import majic.gui.kit.NamedLabel;
import majic.team.Member;
import majic.text.Texts;
import net.miginfocom.swing.MigLayout;

/**
 * Drives robots manually while an arrow key is held and the pad has the focus, or while the mouse is pressed on an
 * arrow. Releasing the key or button stops the robots; so does losing the focus or being hidden. Robots that cannot be
 * driven are left out; if there is no other, the pad looks disabled and shows why.
 */
public final class DrivePad extends JPanel {
    private static final long serialVersionUID = 1L;
    private static final Texts TEXTS = Texts.of(DrivePad.class);
    /** Pixels by which text may be wider on a screen of another scale than measured. */
    private static final int TEXT_RESERVE = 4;

    private static final int FULL_SPEED_PERCENT = 100;
    private static final int LEAST_SPEED_PERCENT = 10;
    private static final int SPEED_STEP_PERCENT = 10;

    private final transient ManualDriver driver;
    private final transient GuardChoice guard;
    private final transient Map<JButton, String> arrows = new LinkedHashMap<>();
    private final JLabel hint = new NamedLabel("", "");
    private final JSlider speed = new JSlider(LEAST_SPEED_PERCENT, FULL_SPEED_PERCENT, FULL_SPEED_PERCENT);
    private final JCheckBox guarded = new JCheckBox();
    private transient List<Member> members = List.of();
    private transient DriveObstacles obstacles = DriveObstacles.of(List.of());

    /**
     * Creates a pad without robots.
     *
     * @param suffix distinguishes the names of the components
     * @param guard whether the robots are guarded
     * @param errors receives the reason when a robot cannot be driven
     */
    public DrivePad(String suffix, GuardChoice guard, Consumer<String> errors) {
        super(new MigLayout("insets 6 10 6 10, gap 4 4", "[][][]16[grow, fill]", "[][]"));
        HelpTopic.set(this, "driving-by-hand");
        this.guard = guard;
        driver = new ManualDriver(guard, errors, () -> System.nanoTime() / 1_000_000);
        setName("drivePad" + suffix);
        setFocusable(true);
        hint.setName("driveHint" + suffix);
        prepareSpeed();
        prepareGuard(suffix);
        placeArrows();
        listen();
        showState(false);
    }

    /** Chooses the robots to drive; those that are driven at the moment and are not among them stop. */
    public void choose(List<Member> newMembers) {
        members = List.copyOf(newMembers);
        driver.choose(members);
        update();
    }

    /** Shows which of the robots can be driven now, and why the others cannot. */
    public void update() {
        DriveObstacles now = DriveObstacles.of(members);
        if (!now.equals(obstacles)) {
            obstacles = now;
            showState(isFocusOwner());
        }
        showGuard();
    }

    private void placeArrows() {
        add(arrow(Direction.AHEAD, "▲", TEXTS.get("ahead")), "cell 1 0");
        add(arrow(Direction.LEFT, "◀", TEXTS.get("left")), "cell 0 1");
        add(arrow(Direction.BACK, "▼", TEXTS.get("backward")), "cell 1 1");
        add(arrow(Direction.RIGHT, "▶", TEXTS.get("right")), "cell 2 1");
        add(hint, "cell 3 0, wmin 0");
        JLabel label = new JLabel(TEXTS.get("speed"));
        label.setLabelFor(speed);
        label.setBorder(BorderFactory.createEmptyBorder(0, 0, 0, TEXT_RESERVE));
        add(label, "cell 3 1, split 3, grow 0");
        add(speed, "cell 3 1, growx, width 60:100:220");
        add(guarded, "cell 3 1, growx, pushx, width 0:110:, gapleft 12");
    }

    private JButton arrow(Direction direction, String sign, String tip) {
        JButton button = new JButton(sign);
        button.setName("drive " + direction);
        button.setFocusable(false);
        button.setPreferredSize(UIScale.scale(new Dimension(44, 30)));
        arrows.put(button, tip);
        button.getAccessibleContext().setAccessibleName(tip);
        button.addMouseListener(new MouseAdapter() {
            @Override
            public void mousePressed(MouseEvent event) {
                if (SwingUtilities.isLeftMouseButton(event)) {
                    requestFocusInWindow();
                    driver.point(direction);
                }
            }

            @Override
            public void mouseReleased(MouseEvent event) {
                driver.point(null);
            }
        });
        return button;
    }

    /** Prepares the slider, which takes no focus: it would take the arrow keys from the pad. */
    private void prepareSpeed() {
        speed.setName("driveSpeed");
        speed.setFocusable(false);
        speed.setToolTipText(TEXTS.get("speed.tip"));
        speed.addChangeListener(change -> driver.share(speed.getValue() / (double) FULL_SPEED_PERCENT));
    }

    /** Prepares the switch, whose text says what holds now; it takes no focus either. */
    private void prepareGuard(String suffix) {
        guarded.setName("driveGuard" + suffix);
        guarded.setFocusable(false);
        guarded.addActionListener(event -> {
            guard.choose(guarded.isSelected());
            showGuard();
        });
    }

    private void showGuard() {
        guarded.setSelected(guard.isOn());
        guarded.setText(GuardSign.text(members, guard.isOn()));
        guarded.setToolTipText(guarded.getText() + ". " + TEXTS.get("guard.tip"));
    }

    private void listen() {
        addKeyListener(new Arrows());
        addMouseListener(new MouseAdapter() {
            @Override
            public void mousePressed(MouseEvent event) {
                requestFocusInWindow();
            }
        });
        addFocusListener(new FocusAdapter() {
            @Override
            public void focusGained(FocusEvent event) {
                showState(true);
            }

            @Override
            public void focusLost(FocusEvent event) {
                driver.stopDriving();
                showState(false);
            }
        });
        addHierarchyListener(change -> {
            if ((change.getChangeFlags() & HierarchyEvent.SHOWING_CHANGED) != 0 && !isShowing()) {
                driver.stopDriving();
            }
        });
    }

    /** Updates the border for the look and feel. */
    @Override
    public void updateUI() {
        super.updateUI();
        if (hint != null) {
            showState(isFocusOwner());
        }
    }

    private void showState(boolean focused) {
        boolean usable = obstacles.someCanBeDriven();
        String advice = obstacles.text(focused);
        getAccessibleContext().setAccessibleName(TEXTS.get("pad", advice));
        hint.setText(advice);
        hint.setToolTipText(obstacles.details());
        hint.setEnabled(usable);
        arrows.forEach((arrow, tip) -> {
            arrow.setEnabled(usable);
            arrow.setToolTipText(usable ? tip : advice);
        });
        setBorder(BorderFactory.createLineBorder(
                UIManager.getColor(focused ? "Component.focusedBorderColor" : "Component.borderColor"),
                focused ? 2 : 1));
    }

    /** Passes the arrow keys on; Page Up and Page Down change the speed. */
    private final class Arrows extends KeyAdapter {
        @Override
        public void keyPressed(KeyEvent event) {
            if (event.getModifiersEx() == 0) {
                Direction.of(event.getKeyCode()).ifPresent(driver::keyPressed);
                changeSpeed(event.getKeyCode());
            }
        }

        private void changeSpeed(int keyCode) {
            if (keyCode == KeyEvent.VK_PAGE_UP) {
                speed.setValue(speed.getValue() + SPEED_STEP_PERCENT);
            } else if (keyCode == KeyEvent.VK_PAGE_DOWN) {
                speed.setValue(speed.getValue() - SPEED_STEP_PERCENT);
            }
        }

        @Override
        public void keyReleased(KeyEvent event) {
            Direction.of(event.getKeyCode()).ifPresent(driver::keyReleased);
        }
    }
}
