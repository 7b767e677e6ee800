package majic.aibo;

import java.awt.Graphics;
import java.awt.Graphics2D;
import javax.swing.JPanel;
import majic.panel.Ink;

/**
 * Draws the dog as large as the room allows: from above, with what its distance sensors meet around its head, and in the
 * corner beside it from its right; faded while disabled. For the event thread.
 */
final class DogDrawing extends JPanel {
    private static final long serialVersionUID = 1;

    /** Of the drawing's size: how far from its foot the head turns, and how far the beams reach beyond. */
    private static final double HEAD_AT = 0.45;

    private static final double REACH = 0.52;
    private static final double WIDTH_TO_HEIGHT = 1.08;

    private final transient Dog dog;

    DogDrawing(Dog dog) {
        this.dog = dog;
        setOpaque(false);
        getAccessibleContext().setAccessibleName("the Aibo from above and from its side");
        setToolTipText("The rings tell how far the infra-red sensors see; filled paws are on the ground");
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D pen = (Graphics2D) graphics.create();
        Ink.prepare(pen);
        Ink ink = isEnabled() ? Ink.ofTheLook() : Ink.ofTheLook().faded();
        double size = Math.min(getHeight(), getWidth() / WIDTH_TO_HEIGHT);
        double foot = (getHeight() + size) / 2;
        double middle = getWidth() / 2.0;
        Graphics2D atHead = (Graphics2D) pen.create();
        atHead.translate(middle, foot - HEAD_AT * size);
        double dogScale = HEAD_AT * size / TopDrawing.BEHIND_HEAD_MM;
        new BeamsDrawing(dog, ink, REACH * size, dogScale * TopDrawing.NOSE_MM).paint(atHead);
        atHead.scale(dogScale, -dogScale);
        new TopDrawing(dog.senses(), ink).paint(atHead);
        atHead.dispose();
        paintSide(pen, ink, middle - dogScale * TopDrawing.HALF_WIDTH_MM, foot, HEAD_AT * size);
        pen.dispose();
    }

    private void paintSide(Graphics2D pen, Ink ink, double width, double foot, double height) {
        double gap = 0.08 * height;
        double scale = Math.min((width - gap) / SideDrawing.LENGTH_MM, (height - 2 * gap) / SideDrawing.HEIGHT_MM);
        pen.translate((width - scale * SideDrawing.LENGTH_MM) / 2 + scale * SideDrawing.TAIL_MM, foot - gap);
        pen.scale(scale, -scale);
        new SideDrawing(dog.senses(), ink).paint(pen);
    }
}
