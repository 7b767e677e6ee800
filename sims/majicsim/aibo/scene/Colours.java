package majicsim.aibo.scene;

import majicsim.world.World;

/** The colours of the room's surfaces in its light. They are chosen here, because maps contain none. */
public final class Colours {
    private static final int PAINT = 0xE6DCC8;
    private static final int CEILING = 0xF2F2EE;
    private static final int HAZE = 0xB4BCC4;
    private static final int LIGHT_TILE = 0xA8886A;
    private static final int DARK_TILE = 0x8E7054;
    private static final int SKIRTING = 0x70604E;
    private static final double TILE_MM = 500;
    private static final double SKIRTING_MM = 80;
    private static final double HALF_LIGHT_MM = 8000;
    private static final double UNLIT = 0.6;

    private final World world;

    public Colours(World world) {
        this.world = world;
    }

    /** The colour of a surface at a place of the room, shaded. */
    public int of(VisibleSurface surface, double xMm, double yMm) {
        double fade = 1 / (1 + surface.levelMm() / HALF_LIGHT_MM);
        return switch (surface.what()) {
            case HAZE -> HAZE;
            case CEILING -> shaded(CEILING, fade);
            case FLOOR -> shaded(tile(xMm, yMm), fade * light(xMm, yMm));
            case ROBOT -> shaded(surface.rgb(), fade * lit(surface.slant()));
            case WALL -> {
                int paint = surface.heightMm() < SKIRTING_MM ? SKIRTING : PAINT;
                yield shaded(paint, fade * lit(surface.slant()) * Math.sqrt(surface.reflectivity()) * light(xMm, yMm));
            }
        };
    }

    private double light(double xMm, double yMm) {
        return Math.min(1, 0.9 + 0.5 * world.ambientLight(xMm, yMm)) * 1.05;
    }

    private static double lit(double slant) {
        return UNLIT + (1 - UNLIT) * slant;
    }

    private static int tile(double xMm, double yMm) {
        long number = (long) Math.floor(xMm / TILE_MM) + (long) Math.floor(yMm / TILE_MM);
        return number % 2 == 0 ? LIGHT_TILE : DARK_TILE;
    }

    private static int shaded(int rgb, double factor) {
        int red = part(rgb >> 16 & 0xFF, factor);
        int green = part(rgb >> 8 & 0xFF, factor);
        return red << 16 | green << 8 | part(rgb & 0xFF, factor);
    }

    private static int part(int value, double factor) {
        return (int) Math.min(255, Math.max(0, Math.rint(value * factor)));
    }
}
