package majic.panel;

import java.awt.Rectangle;
import java.util.List;
import java.util.function.ToIntFunction;

/** Places asides beside a view: one below the other, and under them the readings as far as there is space. */
final class AsideColumn {
    private final List<Aside> asides;
    private final ReadingsPanel<?> numbers;
    private final int gap;

    AsideColumn(List<Aside> asides, ReadingsPanel<?> numbers) {
        this.asides = asides;
        this.numbers = numbers;
        this.gap = numbers.gap() / 2;
    }

    int leastWidth() {
        return asides.stream().mapToInt(Aside::leastWidth).max().orElse(0);
    }

    /** Returns the width at which the readings fit, while the asides have no more than their minimum. */
    int widthForReadings() {
        return Math.max(leastWidth(), numbers.getMinimumSize().width);
    }

    /** Returns the width at which the column is lowest and wide enough for the readings. */
    int goodWidth() {
        return asides.stream().mapToInt(Aside::goodWidth).reduce(widthForReadings(), Math::max);
    }

    int leastHeight(int width) {
        return sum(aside -> aside.leastHeight(width));
    }

    private int sum(ToIntFunction<Aside> height) {
        return asides.stream().mapToInt(height).sum() + (asides.size() - 1) * gap;
    }

    void place(Rectangle room) {
        int rest = room.height - sum(aside -> aside.goodHeight(room.width));
        int rows = numbers.heightWithin(room.width, rest - gap);
        int spare = rows == 0 ? rest : rest - rows - gap;
        int y = room.y;
        for (Aside aside : asides) {
            int height = height(aside, room.width, spare);
            aside.place(room.x, y, room.width, height);
            y += height + gap;
        }
        numbers.place(room.x, y, room.width, rows);
    }

    /** Returns the preferred height, changed by the spare or missing height if the aside is flexible. */
    private static int height(Aside aside, int width, int spare) {
        int good = aside.goodHeight(width);
        int least = aside.leastHeight(width);
        return spare < 0 || aside.takesRest() ? Math.max(least, good + spare) : good;
    }
}
