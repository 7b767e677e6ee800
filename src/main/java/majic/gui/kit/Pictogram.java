package majic.gui.kit;

import java.awt.Shape;

/** The line drawings of buttons and menu entries, in a square of 24 by 24. */
public enum Pictogram {
    ACT(new LineArt().line(5, 4.5, 5, 19.5).area(10, 5.5, 20, 12, 10, 18.5)),
    ADD(new LineArt()
            .circle(11, 13, 7.5)
            .line(11, 13, 18.5, 13)
            .line(19, 3, 19, 9)
            .line(16, 6, 22, 6)),
    DRIVE(new LineArt()
            .area(12, 3.5, 15.5, 8.5, 8.5, 8.5)
            .area(12, 20.5, 15.5, 15.5, 8.5, 15.5)
            .area(3.5, 12, 7, 9, 7, 15)
            .area(20.5, 12, 17, 9, 17, 15)),
    END(new LineArt().area(6, 6, 18, 6, 18, 18, 6, 18)),
    FIND(new LineArt().circle(10.5, 10.5, 6).line(15, 15, 20, 20)),
    HELP(new LineArt()
            .circle(12, 12, 9)
            .arc(12, 9.375, 2.8, 179.5, -239.5)
            .curve(13.4, 11.8, 12.5, 12.3, 12, 12.8, 12, 14)
            .line(12, 17.2, 12, 17.3)),
    LAB(new LineArt()
            .area(3.5, 5.5, 20.5, 5.5, 20.5, 18.5, 3.5, 18.5)
            .circle(9, 13.5, 2.4)
            .line(14, 5.5, 14, 10, 17, 10)),
    LOG(new LineArt().line(4, 4, 4, 20, 20, 20).line(7, 15, 10.5, 10, 13.5, 13, 19, 6)),
    NEW(sheet().line(12.5, 10.5, 12.5, 16.5).line(9.5, 13.5, 15.5, 13.5)),
    OPEN(new LineArt()
            .line(3.5, 19, 3.5, 5.5, 9.5, 5.5, 11.5, 8, 18.5, 8, 18.5, 11)
            .area(3.5, 19, 6.5, 11, 21, 11, 18, 19)),
    PAUSE(new LineArt().line(8.5, 5, 8.5, 19).line(15.5, 5, 15.5, 19)),
    QUIT(new LineArt().line(12, 3, 12, 11.5).arc(12, 11.79, 7.5, 131.8, 276.4)),
    REMOVE(new LineArt()
            .circle(11, 13, 7.5)
            .line(8.2, 10.2, 13.8, 15.8)
            .line(13.8, 10.2, 8.2, 15.8)
            .line(16, 6, 22, 6)),
    RUN(new LineArt().area(7, 4.5, 19, 12, 7, 19.5)),
    RUN_SELECTION(new LineArt().line(4, 5, 4, 19).area(9, 6, 19, 12, 9, 18)),
    SAVE(new LineArt()
            .area(4.5, 4.5, 16.5, 4.5, 19.5, 7.5, 19.5, 19.5, 4.5, 19.5)
            .line(8, 4.5, 8, 9.5, 15, 9.5, 15, 4.5)
            .line(8, 19.5, 8, 13.5, 16, 13.5, 16, 19.5)),
    SESSION(sheet().line(9.5, 10, 12, 12.2, 9.5, 14.4).line(13.5, 15, 16, 15)),
    STEP(new LineArt().area(5, 5.5, 13, 12, 5, 18.5).line(18, 5.5, 18, 18.5)),
    TEAM(new LineArt().circle(12, 8, 3).circle(6, 16, 3).circle(18, 16, 3)),
    TOUR(new LineArt()
            .circle(6, 18, 2)
            .circle(18, 6, 2)
            .line(8, 18, 14.5, 18)
            .arc(14.5, 14.5, 3.5, 270, 180)
            .line(14.5, 11, 9.5, 11)
            .arc(9.5, 7.5, 3.5, 270, -180)
            .line(9.5, 4, 16, 4));

    /** Width and height of the square that a drawing fills. */
    static final int SIDE = 24;

    private final Shape lines;

    Pictogram(LineArt art) {
        lines = art.shape();
    }

    /** Returns the lines of the drawing. */
    Shape lines() {
        return lines;
    }

    private static LineArt sheet() {
        return new LineArt().area(6, 3.5, 15, 3.5, 19, 7.5, 19, 20.5, 6, 20.5);
    }
}
