package majic.gui.acts;

import java.util.Optional;
import javax.swing.JCheckBox;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JTextField;
import majic.act.ActArgument;
import majic.bot.Parameter;
import majic.bot.Range;
import majic.bot.Unit;
import majic.bot.Value;
import majic.gui.kit.Paragraph;
import majic.gui.kit.TextChange;
import majic.text.Texts;

/** The input for one argument of an act, with its purpose below; a wrong value is explained in place of the purpose. */
final class ArgumentInput {
    private static final Texts TEXTS = Texts.of(ArgumentInput.class);

    private final ActArgument argument;
    private final Runnable changed;
    private final JComponent field;
    private final Paragraph hint;
    private Optional<Value> value;

    /**
     * Creates an input that holds the default.
     *
     * @param changed called when the user changes the value
     */
    ArgumentInput(ActArgument argument, Runnable changed) {
        this.argument = argument;
        this.changed = changed;
        value = Optional.of(argument.initial());
        hint = new Paragraph("purpose " + argument.name(), 1, 30);
        hint.showFaint(argument.parameter().help());
        field = switch (argument.parameter().kind()) {
            case YES_NO, ON_OFF -> box();
            case CHOICE -> choice();
            case NUMBER, TEXT, LIST -> text();
        };
        field.setName("argument " + argument.name());
        field.getAccessibleContext().setAccessibleName(argument.name());
        field.getAccessibleContext()
                .setAccessibleDescription(argument.parameter().help());
    }

    private JComponent box() {
        JCheckBox box = new JCheckBox("", argument.initial().isYes());
        box.addActionListener(event -> change(box.isSelected() ? "yes" : "no"));
        return box;
    }

    private JComponent choice() {
        JComboBox<String> choice =
                new JComboBox<>(argument.parameter().choices().toArray(String[]::new));
        choice.setSelectedItem(argument.initial().toString());
        choice.addActionListener(event -> change(String.valueOf(choice.getSelectedItem())));
        return choice;
    }

    private JComponent text() {
        boolean isNumber = argument.initial() instanceof Value.Number;
        JTextField text = new JTextField(
                isNumber ? shown(argument.initial()) : argument.initial().toString(), isNumber ? 7 : 16);
        text.getDocument()
                .addDocumentListener(new TextChange(() -> change(text.getText().strip())));
        return text;
    }

    /** Returns a number without its unit, which stands behind the field. */
    private static String shown(Value number) {
        return ActArgument.typed(Value.of(number.number(), Unit.NONE));
    }

    /** Stores what was entered, if the argument permits it. */
    private void change(String entered) {
        value = read(entered);
        boolean wrong = value.isEmpty();
        field.putClientProperty("JComponent.outline", wrong ? "error" : null);
        if (wrong) {
            hint.show(wanted(), true);
        } else {
            hint.showFaint(argument.parameter().help());
        }
        changed.run();
    }

    private Optional<Value> read(String entered) {
        try {
            Value given = argument.initial() instanceof Value.Number number
                    ? Value.of(Double.parseDouble(entered.replace(',', '.')), number.unit())
                    : Value.text(entered);
            return Optional.of(new ActArgument(argument.parameter(), given).initial());
        } catch (IllegalArgumentException e) {
            return Optional.empty();
        }
    }

    private String wanted() {
        Parameter parameter = argument.parameter();
        Range range = parameter.range();
        if (parameter.kind() == Parameter.Kind.TEXT) {
            return TEXTS.get("text");
        }
        int whole = parameter.whole() ? 1 : 0;
        String from = Value.plain(range.min());
        String to = Value.plain(range.max());
        if (range.min() == Range.ANY.min()) {
            return range.max() == Range.ANY.max() ? TEXTS.get("number", whole) : TEXTS.get("upTo", whole, to);
        }
        return range.max() == Range.ANY.max()
                ? TEXTS.get("atLeast", whole, from)
                : TEXTS.get("between", whole, from, to);
    }

    ActArgument argument() {
        return argument;
    }

    JComponent field() {
        return field;
    }

    /** Returns the line below the field. */
    Paragraph hint() {
        return hint;
    }

    boolean isRight() {
        return value.isPresent();
    }

    /** Returns the value, which is right. */
    Value value() {
        return value.orElseThrow();
    }
}
