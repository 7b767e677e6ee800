package majic.gui.kit;

import static org.assertj.core.api.Assertions.assertThatThrownBy;

import javax.swing.JLabel;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.Test;

class EventThreadGuardTest {
    @Test
    void aChangeOnTheWrongThreadIsFound() {
        JLabel label = new JLabel();
        EventThreadGuard guard = EventThreadGuard.install();
        label.setText("from the test's own thread");
        assertThatThrownBy(guard::checkAndRemove).hasMessageContaining("JLabel");
    }

    @Test
    void aChangeOnTheRightThreadIsFine() throws Exception {
        JLabel label = new JLabel();
        EventThreadGuard guard = EventThreadGuard.install();
        SwingUtilities.invokeAndWait(() -> label.setText("from the event thread"));
        guard.checkAndRemove();
    }
}
