package majic.gui;

import java.awt.BorderLayout;
import java.awt.Color;
import java.awt.Font;
import java.awt.GridBagLayout;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.swing.BorderFactory;
import javax.swing.Box;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import majic.gui.kit.NamedLabel;
import majic.gui.kit.StyledLabel;
import majic.team.StopStatus;
import majic.team.Team;
import majic.team.TeamListener;
import majic.text.NumberList;
import majic.text.Texts;

/**
 * The strip below the buttons that names the robots whose stop was not confirmed, with the reasons and with what to do,
 * and why STOP has not reached other desks. Hidden while there is neither.
 */
final class StopAlarm extends JPanel implements TeamListener {
    private static final long serialVersionUID = 1L;
    private static final Texts TEXTS = Texts.of(StopAlarm.class);
    private static final Color RED = new Color(0xB3261E);

    /** How many reasons are shown; the reasons of further robots are on their cards. */
    private static final int MOST_REASONS = 4;

    private final transient Team team;
    private final JLabel title = white(new StyledLabel("stopAlarm", "", Font.BOLD, 2));
    private final JLabel reasons = white(new NamedLabel("stopReasons", ""));
    private final JLabel remedy = white(new NamedLabel("stopRemedy", TEXTS.get("remedy")));
    private final JButton again = new JButton(TEXTS.get("stopAgain"));

    StopAlarm(Team team) {
        super(new BorderLayout(8, 0));
        this.team = team;
        setBackground(RED);
        setBorder(BorderFactory.createEmptyBorder(6, 12, 6, 12));
        again.setName("stopAgain");
        again.setRequestFocusEnabled(false);
        again.setToolTipText(TEXTS.get("stopAgain.tip"));
        again.addActionListener(event -> stopAgain());
        remedy.setToolTipText(remedy.getText());
        Box texts = Box.createVerticalBox();
        texts.add(title);
        texts.add(reasons);
        texts.add(remedy);
        JPanel button = new JPanel(new GridBagLayout());
        button.setOpaque(false);
        button.add(again);
        add(texts, BorderLayout.CENTER);
        add(button, BorderLayout.EAST);
        showRobots();
    }

    private static JLabel white(JLabel label) {
        label.setForeground(Color.WHITE);
        return label;
    }

    @Override
    public void stopStatusChanged(StopStatus then) {
        showRobots();
    }

    private void showRobots() {
        StopStatus status = team.stopStatus();
        Map<Integer, String> unconfirmed = status.unconfirmed();
        String elsewhere = status.elsewhere();
        setVisible(!unconfirmed.isEmpty() || !elsewhere.isEmpty());
        again.setVisible(!unconfirmed.isEmpty());
        remedy.setVisible(!unconfirmed.isEmpty());
        title.setText(
                unconfirmed.isEmpty()
                        ? TEXTS.get("notElsewhere")
                        : TEXTS.get(
                                "unconfirmed", unconfirmed.size(), NumberList.of(List.copyOf(unconfirmed.keySet()))));
        String why = Stream.of(reasons(unconfirmed), elsewhere)
                .filter(text -> !text.isEmpty())
                .collect(Collectors.joining("   "));
        reasons.setText(why);
        reasons.setToolTipText(why);
    }

    private void stopAgain() {
        Map<Integer, String> unconfirmed = team.stopStatus().unconfirmed();
        team.stop(
                team.members().stream()
                        .filter(member -> unconfirmed.containsKey(member.number()))
                        .toList(),
                null);
    }

    /** Names each reason once, with the robots that it holds for. */
    static String reasons(Map<Integer, String> unconfirmed) {
        Map<String, List<Integer>> robots = new LinkedHashMap<>();
        unconfirmed.forEach((robot, reason) ->
                robots.computeIfAbsent(reason, key -> new ArrayList<>()).add(robot));
        List<String> texts = new ArrayList<>();
        robots.forEach((reason, which) -> texts.add(NumberList.of(which) + ": " + reason));
        if (texts.size() <= MOST_REASONS) {
            return String.join("   ", texts);
        }
        int others = texts.size() - MOST_REASONS + 1;
        return TEXTS.get("reasons.more", String.join("   ", texts.subList(0, MOST_REASONS - 1)), others);
    }
}
