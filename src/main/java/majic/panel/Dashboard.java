package majic.panel;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.LayoutManager;
import java.awt.Rectangle;
import java.util.List;
import java.util.OptionalInt;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;

/**
 * Places a view of a robot with its side panes and readings beside or below it, whichever leaves the larger view. In
 * small panels the readings are left out first, then the view, which is never smaller than it can be read. A banner can
 * be placed above all.
 */
public final class Dashboard implements LayoutManager {
    /** Minimum size of a view in pixels; a smaller one is unreadable. */
    private static final int LEAST_VIEW = 110;

    /** The same beside what is more important than the view, such as readings that stand two in a row. */
    private static final int LEAST_VIEW_BESIDE_PAIRS = 96;

    /** Factor by which the view must get larger to justify a less readable arrangement of the rest. */
    private static final double WORTH_IT = 1.15;

    private final Component view;
    private final double share;
    private final ReadingsPanel<?> numbers;
    private final SidePaneColumn column;
    private final SidePaneRow row;
    private @Nullable Banner banner;

    /**
     * Creates a layout of these children; all have the same parent.
     *
     * @param view gets the space that the others leave; the larger its shorter side, the better it is seen
     * @param share of the width, 0 to 1, for the side panes, which never get less than they need: 0 for a view that can
     *     use all the space that they can spare; 1 for a square view, which leaves them what it cannot use
     * @param sidePanes in the order of reading
     * @param numbers as many of them as fit
     */
    public Dashboard(Component view, double share, List<SidePane> sidePanes, ReadingsPanel<?> numbers) {
        this.view = view;
        this.share = share;
        this.numbers = numbers;
        this.column = new SidePaneColumn(sidePanes, numbers);
        this.row = new SidePaneRow(sidePanes, numbers);
    }

    /**
     * Adds a banner, which is placed above all while it shows a message.
     *
     * @param newBanner a child of the same parent
     * @return this layout
     */
    public Dashboard under(Banner newBanner) {
        banner = newBanner;
        return this;
    }

    @Override
    public void layoutContainer(Container parent) {
        int gap = gap();
        int top = gap / 2;
        Rectangle room = new Rectangle(gap, top, parent.getWidth() - 2 * gap, parent.getHeight() - top - gap);
        int used = placeBanner(room);
        room.y += used;
        room.height = Math.max(0, room.height - used);
        int width = columnWidth(room);
        if (isBetterAbove(room, width)) {
            view.setVisible(true);
            view.setBounds(room.x, room.y, room.width, row.place(room));
        } else {
            placeBeside(room, width);
        }
    }

    /**
     * Returns whether a view above the rest is larger than beside a column of this width, and no important readings are
     * lost.
     */
    private boolean isBetterAbove(Rectangle room, int width) {
        int above = shorterAbove(room);
        return above >= UIScale.scale(LEAST_VIEW)
                && above > WORTH_IT * shorterBeside(room, width)
                && (row.showsReadings(room) || !column.showsPairs(width, room.height));
    }

    /** Returns half the height of a row. */
    private int gap() {
        return numbers.gap() / 2;
    }

    /** Returns the banner's height with the gap below it; 0 while it shows no message. */
    private int bannerHeight(int width) {
        return banner == null || !banner.isVisible() ? 0 : banner.heightIn(width) + gap();
    }

    private int placeBanner(Rectangle room) {
        int used = bannerHeight(room.width);
        if (banner != null && used > 0) {
            banner.setBounds(room.x, room.y, room.width, used - gap());
        }
        return used;
    }

    /**
     * Returns the most readable width of the column that does not reduce the view too much. Readings that stand two in
     * a row are the most important ones: for them the view is reduced as far as it is readable.
     */
    private int columnWidth(Rectangle room) {
        return worthIt(room)
                .filter(width -> column.showsReadings(width, room.height))
                .findFirst()
                .orElseGet(() -> widthForPairs(room)
                        .orElseGet(() -> worthIt(room).findFirst().orElse(column.leastWidth())));
    }

    /** Returns the readable widths of the column that do not reduce the view too much. */
    private IntStream worthIt(Rectangle room) {
        int largest = shorterBeside(room, column.leastWidth());
        return IntStream.of(column.goodWidth(), column.widthForReadings())
                .filter(width -> WORTH_IT * shorterBeside(room, width) >= largest);
    }

    /**
     * Returns the least width with room for readings that stand two in a row: in a wider column, the side panes are
     * lower.
     */
    private OptionalInt widthForPairs(Rectangle room) {
        int narrow = column.widthForPairs();
        return IntStream.of(narrow, Math.max(narrow, column.goodWidth()))
                .filter(width -> column.showsPairs(width, room.height)
                        && shorterBeside(room, width) >= UIScale.scale(LEAST_VIEW_BESIDE_PAIRS))
                .findFirst();
    }

    /** Returns the shorter side of a view with a column beside it; 0 if the column does not fit. */
    private int shorterBeside(Rectangle room, int width) {
        return column.leastHeight(width) > room.height ? 0 : Math.min(room.height, room.width - width - gap());
    }

    private int shorterAbove(Rectangle room) {
        return Math.min(room.width, room.height - row.leastHeight(room.width) - gap());
    }

    private void placeBeside(Rectangle room, int least) {
        int unused = room.width - Math.min(room.width, room.height) - gap();
        int width = Math.max(least, share < 1 ? (int) (share * room.width) : unused);
        int left = room.width - width - gap();
        boolean readable = Math.min(left, room.height) >= UIScale.scale(LEAST_VIEW_BESIDE_PAIRS);
        view.setVisible(readable);
        if (readable) {
            view.setBounds(room.x, room.y, left, room.height);
            column.place(new Rectangle(room.x + room.width - width, room.y, width, room.height));
        } else {
            column.place(room);
        }
    }

    @Override
    public Dimension minimumLayoutSize(Container parent) {
        int width = column.leastWidth() + UIScale.scale(LEAST_VIEW);
        int height = Math.max(UIScale.scale(LEAST_VIEW), column.leastHeight(column.goodWidth()));
        int above = bannerHeight(Math.max(width, parent.getWidth() - 2 * gap()));
        return new Dimension(width + 3 * gap(), height + above + 2 * gap());
    }

    @Override
    public Dimension preferredLayoutSize(Container parent) {
        return minimumLayoutSize(parent);
    }

    @Override
    public void addLayoutComponent(String name, Component component) {
        // all children are known already
    }

    @Override
    public void removeLayoutComponent(Component component) {
        // all stay
    }
}
