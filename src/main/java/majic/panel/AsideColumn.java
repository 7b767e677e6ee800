package majic.panel;

import java.awt.Rectangle;
import java.util.List;
import java.util.function.ToIntFunction;

/** What stands beside a view: asides one below the other, under them the readings as far as there is room. */
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

    /** At which the readings find room, but the asides are no better off than they must be. */
    int widthForReadings() {
        return Math.max(leastWidth(), numbers.getMinimumSize().width);
    }

    /** At which the column is lowest and has the width for readings. */
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

    /** Good, and with what is to spare or to save, if that is up to it. */
    private static int height(Aside aside, int width, int spare) {
        int good = aside.goodHeight(width);
        int least = aside.leastHeight(width);
        return spare < 0 || aside.takesRest() ? Math.max(least, good + spare) : good;
    }
}
