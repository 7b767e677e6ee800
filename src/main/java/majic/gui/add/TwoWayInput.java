package majic.gui.add;

import java.awt.CardLayout;
import java.util.LinkedHashMap;
import java.util.Map;
import javax.swing.ButtonGroup;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JRadioButton;
import majic.bot.BotAddress;
import majic.text.Texts;

/** Selects one of two ways to connect a robot. */
final class TwoWayInput extends AddressInput {
    private static final long serialVersionUID = 1L;
    private static final Texts TEXTS = Texts.of(TwoWayInput.class);

    private final CardLayout cards = new CardLayout();
    private final JPanel deck = new JPanel(cards);
    private final transient Map<AddressInput, JRadioButton> choices = new LinkedHashMap<>();
    private AddressInput chosen;

    TwoWayInput(String firstName, AddressInput first, String secondName, AddressInput second) {
        chosen = first;
        add(new JLabel(TEXTS.get("reachedBy")));
        ButtonGroup group = new ButtonGroup();
        JRadioButton one = choice(group, firstName, first);
        one.setSelected(true);
        add(one, "split 2, grow 0, gapright 12!");
        add(choice(group, secondName, second), "grow 0, gapright push, wrap");
        deck.add(first, firstName);
        deck.add(second, secondName);
        add(deck, "spanx 2, growx");
    }

    private JRadioButton choice(ButtonGroup group, String name, AddressInput input) {
        JRadioButton button = new JRadioButton(name);
        group.add(button);
        choices.put(input, button);
        input.addPropertyChangeListener(PROBLEM, event -> firePropertyChange(PROBLEM, null, event.getNewValue()));
        button.addItemListener(event -> {
            if (button.isSelected()) {
                chosen = input;
                cards.show(deck, name);
            }
        });
        return button;
    }

    @Override
    String address() {
        return chosen.address();
    }

    @Override
    boolean fill(BotAddress address) {
        for (Map.Entry<AddressInput, JRadioButton> choice : choices.entrySet()) {
            if (choice.getKey().fill(address)) {
                choice.getValue().setSelected(true);
                return true;
            }
        }
        return false;
    }

    @Override
    String advice() {
        return chosen.advice();
    }
}
