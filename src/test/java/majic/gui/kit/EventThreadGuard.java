package majic.gui.kit;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import javax.swing.JComponent;
import javax.swing.RepaintManager;
import javax.swing.SwingUtilities;

/** Records every change of a component by a thread that may not change it. */
public final class EventThreadGuard extends RepaintManager {
    private final List<String> violations = new CopyOnWriteArrayList<>();
    private final RepaintManager before = RepaintManager.currentManager(null);

    public static EventThreadGuard install() {
        EventThreadGuard guard = new EventThreadGuard();
        RepaintManager.setCurrentManager(guard);
        return guard;
    }

    @Override
    public synchronized void addInvalidComponent(JComponent component) {
        check(component);
        super.addInvalidComponent(component);
    }

    @Override
    public void addDirtyRegion(JComponent component, int x, int y, int width, int height) {
        check(component);
        super.addDirtyRegion(component, x, y, width, height);
    }

    /** Ends recording, and fails if anything was recorded. */
    public void checkAndRemove() {
        RepaintManager.setCurrentManager(before);
        assertThat(violations).isEmpty();
    }

    private void check(JComponent component) {
        if (SwingUtilities.isEventDispatchThread()) {
            return;
        }
        List<StackTraceElement> stack = Arrays.asList(Thread.currentThread().getStackTrace());
        if (!isRepaintByOurselves(stack)) {
            violations.add(component.getClass().getName() + " changed on " + Thread.currentThread() + ": " + stack);
        }
    }

    /**
     * Returns whether MAJIC's own code called repaint(), which Swing allows on every thread; a call by Swing itself
     * results from a change that it does not allow.
     */
    private static boolean isRepaintByOurselves(List<StackTraceElement> stack) {
        int caller = 0;
        for (int index = 0; index < stack.size(); index++) {
            if (stack.get(index).getMethodName().equals("repaint")) {
                caller = index + 1;
            }
        }
        return caller > 0 && !stack.get(caller).getClassName().startsWith("javax.swing.");
    }
}
