package majic;

import java.util.List;

/** Opens the window and waits until it is done with. */
final class Window {
    private Window() {}

    static int run(Program program, List<String> firstLines) {
        throw new UsageException("there is no window yet; use --console");
    }
}
