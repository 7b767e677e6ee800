package majic.aibo;

import java.awt.BorderLayout;
import java.awt.GridLayout;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.atomic.AtomicBoolean;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.Timer;
import majic.bot.BotException;
import majic.bot.BotListener;
import majic.bot.BotState;
import majic.bot.MajicBot;

/** Shows one dog: drawn from above and from its side, with its readings in numbers beside. */
final class AiboPanel extends JPanel {
    private static final long serialVersionUID = 1;
    private static final int REFRESH_MS = 100;
    private static final int GAP = 8;

    /** What stands in numbers; none of it asks the dog. */
    private static final List<String> SHOWN = List.of(
            "distanceFront",
            "distanceNear",
            "distance",
            "distanceChest",
            "headPan",
            "headTilt",
            "neck",
            "motors",
            "battery",
            "bumped",
            "x",
            "y",
            "heading");

    private final transient MajicAibo bot;
    private final transient AtomicBoolean news = new AtomicBoolean(true);
    private final transient BotListener listener = new News();
    private final Timer refresh = new Timer(REFRESH_MS, event -> refreshIfNews());
    private final Map<String, JLabel> numbers = new LinkedHashMap<>();
    private final JLabel posture = new JLabel("–");
    private final DogDrawing drawing;

    private AiboPanel(MajicAibo bot) {
        super(new BorderLayout(GAP, GAP));
        this.bot = bot;
        this.drawing = new DogDrawing(bot.dog());
        setBorder(BorderFactory.createEmptyBorder(GAP, GAP, GAP, GAP));
        add(drawing, BorderLayout.CENTER);
        add(readings(), BorderLayout.EAST);
    }

    /** Makes the panel; on the event dispatch thread. */
    static JComponent create(MajicAibo bot) {
        return new AiboPanel(bot);
    }

    private JComponent readings() {
        JPanel rows = new JPanel(new GridLayout(0, 2, GAP, 2));
        rows.add(new JLabel("posture"));
        rows.add(posture);
        for (String name : SHOWN) {
            JLabel number = new JLabel("–");
            number.setName("aibo." + name);
            numbers.put(name, number);
            rows.add(new JLabel(name));
            rows.add(number);
        }
        JPanel top = new JPanel(new BorderLayout());
        top.add(rows, BorderLayout.NORTH);
        return top;
    }

    @Override
    public void addNotify() {
        super.addNotify();
        bot.addListener(listener);
        refresh.start();
    }

    @Override
    public void removeNotify() {
        refresh.stop();
        bot.removeListener(listener);
        super.removeNotify();
    }

    private void refreshIfNews() {
        if (news.getAndSet(false)) {
            String guess = bot.dog().senses().posture();
            posture.setText(guess == null ? "–" : guess);
            numbers.forEach((name, label) -> label.setText(reading(name)));
            drawing.repaint();
        }
    }

    private String reading(String name) {
        try {
            return bot.get(name).toString();
        } catch (BotException e) {
            return "–";
        }
    }

    /** Only notes that there is something to show; the timer takes it to the event dispatch thread. */
    private final class News implements BotListener {
        @Override
        public void stateChanged(MajicBot changed, BotState state) {
            news.set(true);
        }

        @Override
        public void connectionChanged(MajicBot changed, MajicBot.Connection connection) {
            news.set(true);
        }
    }
}
