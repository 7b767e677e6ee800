package majic.gui.command;

import java.awt.Component;
import java.awt.Font;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.awt.event.FocusListener;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTextField;
import javax.swing.Timer;
import majic.gui.kit.EventThread;
import majic.gui.kit.HelpTopic;
import majic.gui.kit.NamedLabel;
import majic.gui.kit.Palette;
import majic.gui.kit.TextChange;
import majic.script.Refusal;
import majic.script.help.AnswerForm;
import majic.script.run.Questions;
import majic.script.run.Questions.Question;
import majic.text.Texts;
import net.miginfocom.swing.MigLayout;
import org.jspecify.annotations.Nullable;

/**
 * Shows the oldest question of the scripts in a window, with a field or buttons for the answer. It takes the keyboard
 * focus only when it is clicked or reached by Tab. An answer is submitted as a typed line. A question that ends while
 * its field or a button has the focus stays until Enter or until the focus leaves, since what is typed for it must not
 * go to the command line. Hidden while there is no question. Must be used on the event dispatch thread.
 */
public final class QuestionStrip extends JPanel {
    private static final long serialVersionUID = 1L;
    private static final Texts TEXTS = Texts.of(QuestionStrip.class);
    private static final int REFRESH_MS = 500;

    private final transient Questions questions;
    private final transient Function<String, Optional<Refusal>> submit;
    private final transient Runnable giveFocus;
    private final JLabel question = new NamedLabel("question", "");
    private final JLabel count = new NamedLabel("questionCount", "");
    private final JPanel answers = new JPanel(new MigLayout("insets 0, gap 6"));
    private final JLabel otherwise = new NamedLabel("questionDefault", "");
    private final JLabel refused = new NamedLabel("answerRefused", "");
    private final transient FocusListener leaving = new FocusAdapter() {
        @Override
        public void focusLost(FocusEvent event) {
            EventThread.later(QuestionStrip.this::showOldest);
        }
    };
    private final Timer refresh = new Timer(REFRESH_MS, event -> showTime());
    private transient @Nullable Question shown;

    /**
     * Creates a strip that follows the questions.
     *
     * @param submit submits the line of an answer; returns why it is refused, if it is
     * @param giveFocus gives the focus to another component, when a question ends that has it
     */
    public QuestionStrip(Questions questions, Function<String, Optional<Refusal>> submit, Runnable giveFocus) {
        super(new MigLayout("insets 4 8 4 8, gap 8 2, hidemode 3", "[][grow, fill][]"));
        this.questions = questions;
        this.submit = submit;
        this.giveFocus = giveFocus;
        HelpTopic.set(this, "questions-of-scripts");
        setName("questionStrip");
        answers.setOpaque(false);
        add(question, "span 2, growx, wmin 0");
        add(count, "wrap");
        add(answers, "");
        add(otherwise, "span 2, wmin 0, wrap");
        add(refused, "span 3, growx, wmin 0");
        setVisible(false);
        colour();
        questions.addListener(() -> EventThread.later(this::showOldest));
        showOldest();
    }

    /** Updates the colours for the look and feel. */
    @Override
    public void updateUI() {
        super.updateUI();
        if (refused != null) {
            colour();
        }
    }

    private void colour() {
        setBackground(Palette.mixed(0.12));
        setBorder(BorderFactory.createMatteBorder(1, 1, 1, 1, Palette.mixed(0.25)));
        question.setFont(getFont().deriveFont(Font.BOLD));
        refused.setForeground(Palette.error());
    }

    private List<Question> waiting() {
        return questions.open().stream().filter(one -> one.answer() == null).toList();
    }

    private void showOldest() {
        List<Question> waiting = waiting();
        Question oldest = waiting.isEmpty() ? null : waiting.get(0);
        count.setText(waiting.size() > 1 ? TEXTS.get("question.count", 1, waiting.size()) : "");
        if (oldest != shown && !isFocusInside()) {
            show(oldest);
        } else if (oldest != shown) {
            refresh.stop();
            otherwise.setText(TEXTS.get("question.ended"));
        }
    }

    private void showNext() {
        List<Question> waiting = waiting();
        show(waiting.isEmpty() ? null : waiting.get(0));
        showOldest();
    }

    /** Shows another question, or none; a field that had the focus gives it away. */
    private void show(@Nullable Question oldest) {
        boolean hadFocus = isFocusInside();
        shown = oldest;
        answers.removeAll();
        refuse("");
        if (oldest == null) {
            refresh.stop();
        } else {
            question.setText(oldest.text());
            question.setToolTipText(oldest.text());
            addAnswers(oldest);
            showTime();
            refresh.start();
        }
        setVisible(oldest != null);
        revalidate();
        repaint();
        if (hadFocus) {
            giveFocus.run();
        }
    }

    private boolean isFocusInside() {
        for (Component component : answers.getComponents()) {
            if (component.isFocusOwner()) {
                return true;
            }
        }
        return false;
    }

    private void addAnswers(Question asked) {
        AnswerForm form = new AnswerForm(asked);
        List<String> words = form.words();
        if (words.isEmpty()) {
            addField(asked, form);
        } else {
            words.forEach(word -> addButton(word, "answer " + word, () -> answer(asked, form.line(word))));
        }
    }

    private void addField(Question asked, AnswerForm form) {
        JTextField field = new JTextField(form.initial(), 14);
        field.setName("answerField");
        field.getAccessibleContext().setAccessibleName(asked.text());
        field.selectAll();
        Runnable answer = () -> answer(asked, form.line(field.getText()));
        field.addActionListener(event -> answer.run());
        field.getDocument().addDocumentListener(new TextChange(() -> refuse("")));
        field.addFocusListener(leaving);
        answers.add(field);
        addButton(TEXTS.get("question.answer"), "answer", answer);
        answers.add(new NamedLabel("answerRange", form.range()));
    }

    private void addButton(String text, String name, Runnable action) {
        JButton button = new JButton(text);
        button.setName(name);
        button.addFocusListener(leaving);
        button.addActionListener(event -> action.run());
        answers.add(button);
    }

    /** Submits an answer, unless the question has ended meanwhile: another one would get it. */
    private void answer(Question asked, String answer) {
        List<Question> waiting = waiting();
        if (waiting.isEmpty() || waiting.get(0) != asked) {
            showNext();
            return;
        }
        Optional<Refusal> refusal = submit.apply(answer);
        if (refusal.isPresent()) {
            refuse(refusal.get().message());
        } else {
            showNext();
        }
    }

    private void refuse(String why) {
        refused.setText(why);
        refused.setToolTipText(why.isEmpty() ? null : why);
        refused.setVisible(!why.isEmpty());
        for (Component component : answers.getComponents()) {
            if (component instanceof JTextField field) {
                field.putClientProperty("JComponent.outline", why.isEmpty() ? null : "error");
            }
        }
        revalidate();
    }

    private void showTime() {
        Question asked = shown;
        if (asked != null) {
            long seconds = (long) Math.ceil(asked.secondsLeft());
            otherwise.setText(TEXTS.get("question.otherwise", asked.otherwise().toString(), seconds));
        }
    }
}
