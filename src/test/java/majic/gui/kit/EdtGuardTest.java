package majic.gui.kit;

import static org.assertj.core.api.Assertions.assertThatThrownBy;

import javax.swing.JLabel;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(30)
class EdtGuardTest {
    @Test
    void aChangeOnTheWrongThreadIsFound() {
        JLabel label = new JLabel();
        EdtGuard guard = EdtGuard.install();
        label.setText("from the test's own thread");
        assertThatThrownBy(guard::checkAndRemove).hasMessageContaining("JLabel");
    }

    @Test
    void aChangeOnTheRightThreadIsFine() throws Exception {
        JLabel label = new JLabel();
        EdtGuard guard = EdtGuard.install();
        SwingUtilities.invokeAndWait(() -> label.setText("from the event thread"));
        guard.checkAndRemove();
    }
}
