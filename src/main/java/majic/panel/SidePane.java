package majic.panel;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Component;
import java.awt.Dimension;

/**
 * A component beside or below the view of a {@link Dashboard}, with the space it needs. Must be used on the event
 * dispatch thread.
 */
public abstract class SidePane {
    private static final int LEAST_PICTURE = 60;
    private static final int LEAST_MAP = 80;
    private static final int GOOD_MAP = 130;

    private final Component component;

    private SidePane(Component component) {
        this.component = component;
    }

    /**
     * Creates a side pane of the component's preferred height that is never left out.
     *
     * @param component with at least its minimum width
     * @return for a dashboard
     */
    public static SidePane of(Component component) {
        return new SidePane(component) {};
    }

    /**
     * Creates a side pane of status lights that is never left out: two per row where that costs the view little, else
     * one per row.
     *
     * @param lights with all their words
     * @return for a dashboard
     */
    public static SidePane of(StatusLightsPanel lights) {
        return new Lights(lights);
    }

    /**
     * Creates a side pane that is never left out and folds where it would cost the view much.
     *
     * @param folding a component that is narrower and higher when it is folded
     * @param <C> its class
     * @return for a dashboard
     */
    public static <C extends Component & FoldingPane> SidePane folding(C folding) {
        return new Folding(folding, folding);
    }

    /**
     * Creates a side pane that keeps the aspect ratio of its preferred size while there is enough height, and gets
     * smaller otherwise.
     *
     * @param picture of any size
     * @return for a dashboard
     */
    public static SidePane shaped(Component picture) {
        return new Shaped(picture);
    }

    /**
     * Creates a side pane that takes the space that the others and the readings leave, and is hidden when that is too
     * little.
     *
     * @param map any shape will do
     * @return for a dashboard
     */
    public static SidePane stretched(Component map) {
        return new Stretched(map);
    }

    /**
     * Creates a side pane that takes the space that the others and all readings leave, and is hidden when that is too
     * little: for what is less important than the readings.
     *
     * @param list any shape will do
     * @return for a dashboard
     */
    public static SidePane spare(Component list) {
        return new Spare(list);
    }

    final Component component() {
        return component;
    }

    int leastWidth() {
        return component.getMinimumSize().width;
    }

    /** Returns the width at which it is most readable, or lowest. */
    int goodWidth() {
        return leastWidth();
    }

    /** Returns its minimum height; 0 if it may be left out. */
    int leastHeight(int width) {
        return goodHeight(width);
    }

    int goodHeight(int width) {
        return component.getPreferredSize().height;
    }

    boolean takesRest() {
        return false;
    }

    /** Sets its bounds, or hides it if they are too small for it. */
    void place(int x, int y, int width, int height) {
        component.setBounds(x, y, width, height);
    }

    private static final class Lights extends SidePane {
        private final StatusLightsPanel lights;

        Lights(StatusLightsPanel lights) {
            super(lights);
            this.lights = lights;
        }

        @Override
        int leastWidth() {
            return lights.widthOf(1);
        }

        @Override
        int goodWidth() {
            return lights.widthOf(2);
        }

        @Override
        int goodHeight(int width) {
            return lights.heightIn(width);
        }
    }

    private static final class Folding extends SidePane {
        private final FoldingPane folding;

        Folding(Component component, FoldingPane folding) {
            super(component);
            this.folding = folding;
        }

        @Override
        int leastWidth() {
            return folding.foldedWidth();
        }

        @Override
        int goodWidth() {
            return folding.unfoldedWidth();
        }

        @Override
        int goodHeight(int width) {
            return folding.heightIn(width);
        }
    }

    private static final class Shaped extends SidePane {
        Shaped(Component picture) {
            super(picture);
        }

        @Override
        int leastWidth() {
            return UIScale.scale(LEAST_PICTURE);
        }

        @Override
        int leastHeight(int width) {
            return UIScale.scale(LEAST_PICTURE);
        }

        @Override
        int goodHeight(int width) {
            Dimension shape = component().getPreferredSize();
            return width * shape.height / shape.width;
        }
    }

    private static class Stretched extends SidePane {
        Stretched(Component map) {
            super(map);
        }

        @Override
        int leastWidth() {
            return UIScale.scale(LEAST_MAP);
        }

        @Override
        int leastHeight(int width) {
            return 0;
        }

        @Override
        int goodHeight(int width) {
            return UIScale.scale(GOOD_MAP);
        }

        @Override
        boolean takesRest() {
            return true;
        }

        @Override
        void place(int x, int y, int width, int height) {
            boolean fits = width >= leastWidth() && height >= leastWidth();
            component().setVisible(fits);
            super.place(x, y, fits ? width : 0, fits ? height : 0);
        }
    }

    private static final class Spare extends Stretched {
        Spare(Component list) {
            super(list);
        }

        @Override
        int goodHeight(int width) {
            return 0;
        }
    }
}
