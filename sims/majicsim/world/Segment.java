package majicsim.world;

/**
 * A straight piece of wall.
 *
 * @param x1 one end, mm
 * @param y1 one end, mm
 * @param x2 the other end, mm
 * @param y2 the other end, mm
 * @param reflectivity how well it reflects infra-red light; white paper is 1 (Hemisson sheet 6)
 */
public record Segment(double x1, double y1, double x2, double y2, double reflectivity) {}
