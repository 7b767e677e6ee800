package majic.panel;

import java.awt.Rectangle;
import java.util.List;

/** Places asides below a view: side by side, and below all of them the readings as far as there is space. */
final class AsideStrip {
    private final List<Aside> asides;
    private final ReadingsPanel<?> numbers;
    private final int gap;

    AsideStrip(List<Aside> asides, ReadingsPanel<?> numbers) {
        this.asides = asides;
        this.numbers = numbers;
        this.gap = numbers.gap() / 2;
    }

    /**
     * Returns the minimum height without the readings; larger than any available height if the width is too small for
     * the asides.
     */
    int leastHeight(int width) {
        int each = widthOfEach(width);
        boolean fits = asides.stream().allMatch(aside -> aside.leastWidth() <= each);
        return fits
                ? asides.stream()
                        .mapToInt(aside -> aside.goodHeight(each))
                        .max()
                        .orElse(0)
                : Short.MAX_VALUE;
    }

    private int widthOfEach(int width) {
        return (width - (asides.size() - 1) * 2 * gap) / asides.size();
    }

    /**
     * Places the strip at the bottom of an area, as high as a square view permits; returns the height left for the
     * view.
     */
    int place(Rectangle room) {
        int each = widthOfEach(room.width);
        int height = leastHeight(room.width);
        int spare = Math.max(0, room.height - height - gap - room.width);
        int rows = numbers.heightWithin(room.width, spare - gap);
        if (asides.stream().anyMatch(Aside::takesRest)) {
            height += rows == 0 ? spare : spare - rows - gap;
        }
        int y = room.y + room.height - height - (rows == 0 ? 0 : rows + gap);
        int x = room.x;
        for (Aside aside : asides) {
            aside.place(x, y, each, aside.takesRest() ? height : Math.min(height, aside.goodHeight(each)));
            x += each + 2 * gap;
        }
        numbers.place(room.x, room.y + room.height - rows, room.width, rows);
        return y - gap - room.y;
    }
}
