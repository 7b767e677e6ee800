package majicsim.aibo.scene;

/** A point or a direction in space, in mm: x ahead, y to the left, z up, of the dog or of the room. Immutable. */
public record Vector(double x, double y, double z) {

    Vector plus(Vector other) {
        return new Vector(x + other.x, y + other.y, z + other.z);
    }

    public Vector minus(Vector other) {
        return new Vector(x - other.x, y - other.y, z - other.z);
    }

    public Vector times(double factor) {
        return new Vector(x * factor, y * factor, z * factor);
    }

    double dot(Vector other) {
        return x * other.x + y * other.y + z * other.z;
    }

    double length() {
        return Math.sqrt(dot(this));
    }

    /** Its length on the floor. */
    public double level() {
        return Math.sqrt(x * x + y * y);
    }

    /** Its direction on the floor, in degrees counter-clockwise from x. */
    public double azimuthDeg() {
        return Math.toDegrees(Math.atan2(y, x));
    }

    /** Turned about z, counter-clockwise as seen from above. */
    Vector turned(double degrees) {
        double cos = Math.cos(Math.toRadians(degrees));
        double sin = Math.sin(Math.toRadians(degrees));
        return new Vector(x * cos - y * sin, x * sin + y * cos, z);
    }

    /** Turned about y: a positive angle turns ahead to up. */
    public Vector pitched(double degrees) {
        double cos = Math.cos(Math.toRadians(degrees));
        double sin = Math.sin(Math.toRadians(degrees));
        return new Vector(x * cos - z * sin, y, x * sin + z * cos);
    }

    /** Turned about x: a positive angle turns left to up. */
    public Vector rolled(double degrees) {
        double cos = Math.cos(Math.toRadians(degrees));
        double sin = Math.sin(Math.toRadians(degrees));
        return new Vector(x, y * cos - z * sin, y * sin + z * cos);
    }
}
